#include "sim/reference/arc_meter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/reference/drift_columns.h"
#include "sim/result/estimate.h"

namespace hyrax {
namespace {

double largest(double so_far, double a, double b) {
  return larger(so_far, larger(std::fabs(a), std::fabs(b)));
}

void include_worst(std::optional<Worst>& worst, std::optional<double> value, std::int64_t step) {
  if (!value) return;
  if (!worst || std::fabs(*value) > std::fabs(worst->value) ||
      (std::isnan(*value) && !std::isnan(worst->value)))
    worst = Worst{*value, step};
}

void include_all_worst(DriftSummary& summary, const auto& columns, const auto& record, std::int64_t step) {
  for (const auto& column : columns)
    if (column.also.worst != nullptr) include_worst(summary.*column.also.worst, column.number(record), step);
}

}  // namespace

std::optional<double> LineFit::slope_per_s() const {
  const double spread = count_ * t_t_ - t_ * t_;
  if (!(spread > 0.0)) return std::nullopt;
  return (count_ * t_value_ - t_ * value_) / spread;
}

void Spread::add(double value) {
  smallest_ = std::min(smallest_, value);
  largest_ = std::max(largest_, value);
  if (count_++ % kept_every_ != 0) return;
  kept_.push_back(value);
  if (kept_.size() < kKeptMax) return;
  for (std::size_t index = 0; 2 * index < kept_.size(); ++index) kept_[index] = kept_[2 * index];
  kept_.resize(kept_.size() / 2);
  kept_every_ *= 2;
}

double Spread::median() const { return quantile(kept_, 0.5); }

ArcMeter::ArcMeter(const Model& model, DriftSink& sink, FlightSolver* solver)
    : model_(model),
      sink_(sink),
      wants_rows_(sink.wants_rows()),
      solution_(model),
      walls_(model.gravity_px_per_s2, solution_.log_air_drag(), time_of_impact),
      causes_(model.gravity_px_per_s2) {
  if (solver != nullptr) check_.emplace(model, *solver);
}

void ArcMeter::begin(const ArcStart& start) { open(start, wants_rows_); }

void ArcMeter::open(const ArcStart& start, bool tells_rows) {
  tells_rows_ = tells_rows;
  start_ = start;
  last_ = start.row;
  const Velocity velocity{start.row.vx_px_per_s, start.row.vy_px_per_s};
  first_ = seen_from_start(start.row);
  gathered_ = {};
  gathered_.drift_fit.add(0.0, 0.0);
  arc_ = {.first_step = start.row.step,
          .solves_x = velocity.vx_px_per_s != 0.0,
          .energy_largest_px2_per_s2 = energy(first_),
          .coordinate_largest_px = largest(0.0, start.row.x_px, start.row.y_px)};
  solution_.start(velocity, arc_.solves_x);
  walls_.start(start);
  if (check_) check_->start(start, arc_.solves_x, arc_.energy_largest_px2_per_s2);
  if (tells_rows_) tell_row(first_, first_, first_, {});
}

void ArcMeter::fly(const Row& row) {
  solution_.advance(row.dt_s);
  const State run = seen_from_start(row);
  const State discrete = solution_.discrete();
  const State matched = solution_.matched();
  const State law = solution_.exact_law();
  const Position model = solution_.model();
  const double elapsed_s = solution_.elapsed_s();
  Gathered& g = gathered_;
  g.implementation.add(run.x_px - discrete.x_px, run.y_px - discrete.y_px);
  g.implementation_speed.add(run.vx_px_per_s - discrete.vx_px_per_s, run.vy_px_per_s - discrete.vy_px_per_s);
  g.truncation.add(run.x_px - matched.x_px, run.y_px - matched.y_px);
  g.truncation_speed.add(run.vx_px_per_s - matched.vx_px_per_s, run.vy_px_per_s - matched.vy_px_per_s);
  g.exact_law.add(run.x_px - law.x_px, run.y_px - law.y_px);
  g.exact_law_speed.add(run.vx_px_per_s - law.vx_px_per_s, run.vy_px_per_s - law.vy_px_per_s);
  g.model.add(run.x_px - model.x_px, run.y_px - model.y_px);
  const double energy_now = energy(matched);
  const double drift = gain(matched, run);
  g.drift_fit.add(elapsed_s, drift);
  arc_.coordinate_largest_px = largest(largest(arc_.coordinate_largest_px, row.x_px, row.y_px),
                                       start_.row.x_px + matched.x_px, start_.row.y_px + matched.y_px);
  arc_.energy_largest_px2_per_s2 = larger(arc_.energy_largest_px2_per_s2, energy_now);
  arc_.energy_drift_end_px2_per_s2 = drift;
  arc_.energy_drift_max_px2_per_s2 = larger(arc_.energy_drift_max_px2_per_s2, std::fabs(drift));
  walls_.add(matched, row.dt_s, elapsed_s);
  if (differs_from_listing(row)) ++arc_.differing_steps;
  if (check_) check_->check_row({matched, energy_now, gain(first_, matched)}, row.dt_s, elapsed_s);
  last_ = row;
  if (tells_rows_) tell_row(run, discrete, matched, model);
}

void ArcMeter::end(ArcEnd ended_by, const Row* clamped) {
  close(ended_by, clamped != nullptr ? clamped->contact : std::uint8_t{0}, clamped, true);
}

// Walls that clamped the row before as well go on with a contact that is listed already.
void ArcMeter::short_arc(const ArcStart& start, const Row* flown, const Row* clamped) {
  const unsigned hit = clamped != nullptr ? clamped->contact & ~kRestBit : 0u;
  const unsigned before = flown != nullptr ? 0u : start.row.contact;
  const auto begun = static_cast<std::uint8_t>(hit & ~before);
  if (flown == nullptr && begun == 0) {
    start_ = start;
    last_ = start.row;
    summary_.unlisted_energy_px2_per_s2 += gain(seen_from_start(start.row), seen_from_start(*clamped));
    return;
  }
  open(start, false);
  if (flown != nullptr) {
    fly(*flown);
    summary_.unlisted_energy_px2_per_s2 += gain(first_, seen_from_start(*flown));
  }
  close(ArcEnd::end, begun, clamped, false);
}

// @param walls whose contacts begin: in a corner x before y. @param is_listed whether the arc is, too.
void ArcMeter::close(ArcEnd ended_by, std::uint8_t walls, const Row* clamped, bool is_listed) {
  finish_errors(ended_by);
  std::vector<ImpactErrors> contacts;
  for (const Wall wall : kWalls)
    if (touches(walls, wall)) contacts.push_back(impact_errors(wall, *clamped));
  verify();
  count_fault();
  if (is_listed) report_arc();
  if (contacts.empty()) return;
  solution_.advance(clamped->dt_s);
  const double drift = gain(solution_.matched(), seen_from_start(step_from_last(clamped->dt_s)));
  contacts.front().flight_error_px2_per_s2 = drift - (is_listed ? arc_.energy_drift_end_px2_per_s2 : 0.0);
  contacts.back().is_second_of_corner = contacts.size() > 1;
  for (const ImpactErrors& contact : contacts)
    report_contact(contact, contact.wall == Wall::ground && (clamped->contact & kRestBit) != 0);
}

// e = (vx^2 + vy^2) / 2 + g (bottom - y), specific energy in px^2/s^2, 0 at rest on the floor.
double ArcMeter::energy(const State& flight) const {
  const double kinetic =
      0.5 * (flight.vx_px_per_s * flight.vx_px_per_s + flight.vy_px_per_s * flight.vy_px_per_s);
  return kinetic + model_.gravity_px_per_s2 * ((start_.bounds.bottom_px - start_.row.y_px) - flight.y_px);
}

// The paper's step from the arc's last row, before any clamp: each operation rounded.
Row ArcMeter::step_from_last(double dt_s) const {
  Row next;
  next.vx_px_per_s = last_.vx_px_per_s * model_.air_drag;
  next.vy_px_per_s = (last_.vy_px_per_s + model_.gravity_px_per_s2 * dt_s) * model_.air_drag;
  next.x_px = last_.x_px + next.vx_px_per_s * dt_s;
  next.y_px = last_.y_px + next.vy_px_per_s * dt_s;
  return next;
}

bool ArcMeter::differs_from_listing(const Row& row) const {
  const Row step = step_from_last(row.dt_s);
  return row.x_px != step.x_px || row.y_px != step.y_px || row.vx_px_per_s != step.vx_px_per_s ||
         row.vy_px_per_s != step.vy_px_per_s;
}

// Called once last_ is the row.
void ArcMeter::tell_row(const State& run, const State& discrete, const State& matched,
                        const Position& model) {
  sink_.row({.step = last_.step,
             .t_s = last_.t_s,
             .x_px = start_.row.x_px + matched.x_px,
             .y_px = start_.row.y_px + matched.y_px,
             .vx_px_per_s = matched.vx_px_per_s,
             .vy_px_per_s = matched.vy_px_per_s,
             .implementation_px = distance(run.x_px - discrete.x_px, run.y_px - discrete.y_px),
             .truncation_px = distance(run.x_px - matched.x_px, run.y_px - matched.y_px),
             .model_px = distance(run.x_px - model.x_px, run.y_px - model.y_px),
             .energy_px2_per_s2 = energy(matched),
             .energy_drift_px2_per_s2 = arc_.energy_drift_end_px2_per_s2});
}

// Once its last row was flown.
void ArcMeter::finish_errors(ArcEnd ended_by) {
  const Gathered& g = gathered_;
  arc_.last_step = last_.step;
  arc_.t_s = last_.t_s;
  arc_.duration_s = solution_.elapsed_s();
  arc_.ended_by = ended_by;
  arc_.implementation_px = g.implementation.value();
  arc_.truncation_px = g.truncation.value();
  arc_.model_px = g.model.value();
  arc_.implementation_px_per_s = g.implementation_speed.value();
  arc_.truncation_px_per_s = g.truncation_speed.value();
  arc_.exact_law_px = g.exact_law.value();
  arc_.exact_law_px_per_s = g.exact_law_speed.value();
  const double of_one_px = model_.gravity_px_per_s2;
  double& scale = arc_.energy_scale_px2_per_s2;
  if (const double largest = std::max(arc_.energy_largest_px2_per_s2, of_one_px); largest != 0.0)
    scale = largest;
  arc_.energy_drift_rel_max = arc_.energy_drift_max_px2_per_s2 / scale;
  arc_.energy_drift_rel_end = arc_.energy_drift_end_px2_per_s2 / scale;
  if (const auto slope = g.drift_fit.slope_per_s()) {
    arc_.energy_drift_slope_per_s = *slope / scale;
    if (of_one_px > 0.0) arc_.energy_drift_slope_px_per_s = *slope / of_one_px;
  }
  const double by_gravity = solution_.gravity_energy_px2_per_s2();
  arc_.energy_parts = {by_gravity, arc_.energy_drift_end_px2_per_s2 - by_gravity};
}

// Once the arc and its contacts are measured.
void ArcMeter::verify() {
  if (check_) {
    check_->check_model(solution_.model(), solution_.elapsed_s());
    arc_.gsl_vs_closed_px = check_->apart_px();
    arc_.reference_fault = check_->fault(arc_.coordinate_largest_px);
  }
  // The rows are finite; so is all that is measured of them.
  const double sum = arc_.implementation_px + arc_.truncation_px + arc_.model_px +
                     arc_.implementation_px_per_s + arc_.truncation_px_per_s + arc_.exact_law_px +
                     arc_.exact_law_px_per_s + arc_.energy_largest_px2_per_s2 + arc_.energy_drift_rel_max +
                     arc_.energy_drift_slope_per_s.value_or(0.0);
  if (!std::isfinite(sum)) arc_.reference_fault = "a value is not finite";
}

ImpactErrors ArcMeter::impact_errors(Wall wall, const Row& clamped) {
  const State unclamped = state_of(step_from_last(clamped.dt_s));
  const double past_px = approach_to(wall, place_px(wall, start_.bounds), unclamped, 0.0, 0.0).position_px;
  ImpactErrors contact{.step = clamped.step,
                       .t_s = clamped.t_s,
                       .wall = wall,
                       .overshoot_px = larger(0.0, past_px),
                       .energy_jump_px2_per_s2 = gain(seen_from_start(last_), seen_from_start(clamped)),
                       .energy_parts = contact_energy(clamped)};
  contact.energy_jump_rel = contact.energy_jump_px2_per_s2 / arc_.energy_scale_px2_per_s2;
  std::optional<Impact> impact = walls_.impact(wall, clamped.dt_s);
  if (impact) {
    contact.time_error_s = clamped.dt_s - impact->t_s;
    if (impact->speed_px_per_s != 0.0)
      contact.effective_restitution = speed_after(wall, clamped) / impact->speed_px_per_s;
    contact.bounce_error_px2_per_s2 = bounce_error(wall, clamped.dt_s, impact->speed_px_per_s);
    impact->t_s = clamped.dt_s - *contact.time_error_s;  // What is reported is what is checked.
  }
  if (check_) check_->check_impact(wall, clamped.dt_s, impact);
  return contact;
}

// Each operation of the paper's step from the arc's last row, and what it does to the energy.
ContactEnergyParts ArcMeter::contact_energy(const Row& clamped) const {
  const auto hits = [&](Wall wall) { return touches(clamped.contact, wall); };
  State now = seen_from_start(last_);
  const auto gain_to = [&](const State& next) { return gain(std::exchange(now, next), next); };
  ContactEnergyParts parts;
  State next = seen_from_start(step_from_last(clamped.dt_s));
  parts.flight = gain_to(next);
  next.y_px = clamped.y_px - start_.row.y_px;
  parts.lift = gain_to(next);
  if (hits(Wall::left) || hits(Wall::right)) next.vx_px_per_s *= -model_.restitution;
  if (hits(Wall::top) || hits(Wall::ground)) next.vy_px_per_s *= -model_.restitution;
  parts.bounce = gain_to(next);
  if (hits(Wall::ground)) next.vx_px_per_s *= model_.ground_friction;
  parts.friction = gain_to(next);
  if ((clamped.contact & kRestBit) != 0) next.vy_px_per_s = 0.0;
  parts.rest = gain_to(next);
  return parts;
}

double ArcMeter::bounce_error(Wall wall, double dt_s, double impact_speed_px_per_s) const {
  const Row unclamped = step_from_last(dt_s);
  const double speed = std::fabs(is_at_side(wall) ? unclamped.vx_px_per_s : unclamped.vy_px_per_s);
  return -0.5 * (1.0 - model_.restitution * model_.restitution) *
         ((speed - impact_speed_px_per_s) * (speed + impact_speed_px_per_s));
}

// In a corner the floor's friction acts on vx after the wall in x has turned it.
double ArcMeter::speed_after(Wall wall, const Row& clamped) const {
  if (!is_at_side(wall)) return std::fabs(clamped.vy_px_per_s);
  const double speed = std::fabs(clamped.vx_px_per_s);
  return touches(clamped.contact, Wall::ground) ? speed / model_.ground_friction : speed;
}

// Differences of coordinates that lie near each other are exact.
State ArcMeter::seen_from_start(const Row& row) const {
  return {row.x_px - start_.row.x_px, row.y_px - start_.row.y_px, row.vx_px_per_s, row.vy_px_per_s};
}

void ArcMeter::count_fault() {
  DriftSummary& s = summary_;
  if (arc_.reference_fault.empty() || s.reference_faults++ > 0) return;
  s.first_reference_fault_step = arc_.first_step;
  s.first_reference_fault = arc_.reference_fault;
}

void ArcMeter::report_arc() {
  DriftSummary& s = summary_;
  ++s.arcs;
  if (!arc_.solves_x) ++s.arcs_without_x;
  s.differing_steps += arc_.differing_steps;
  if (open_contacts_.empty())
    causes_.add(arc_.energy_parts);
  else
    open_arcs_ += arc_.energy_parts;
  s.reference_energy_px2_per_s2 += gain(first_, solution_.matched());
  drift_of_all_arcs_.add_line(gathered_.drift_fit);
  if (const auto slope = drift_of_all_arcs_.slope_per_s(); slope && model_.gravity_px_per_s2 > 0.0)
    s.secular_px_per_s = *slope / model_.gravity_px_per_s2;
  include_all_worst(s, kArcColumns, arc_, arc_.first_step);
  include_all_worst(s, kReferenceArcColumns, arc_, arc_.first_step);
  sink_.arc(arc_);
}

void ArcMeter::report_contact(const ImpactErrors& contact, bool is_stopped) {
  ++summary_.contacts;
  if (contact.wall != Wall::ground && open_contacts_.empty()) {
    include(contact, is_stopped);
    causes_.add(contact);
  } else if (open_contacts_.size() < kContactsOpenMax) {
    open_contacts_.push_back({contact, is_stopped});
  }
  sink_.contact(contact);
}

void ArcMeter::include(const ImpactErrors& contact, bool is_stopped) {
  include_all_worst(summary_, kImpactColumns, contact, contact.step);
  if (contact.effective_restitution && !is_stopped)
    summary_.effective_restitution.add(*contact.effective_restitution);
}

void ArcMeter::settle(std::int64_t end_step, std::optional<std::int64_t> resting_from_step) {
  if (open_contacts_.empty()) return;
  for (const OpenContact& open : open_contacts_) {
    const std::int64_t step = open.errors.step;
    const bool is_resting = resting_from_step && step >= *resting_from_step && step < end_step;
    if (!is_resting || open.errors.wall != Wall::ground) include(open.errors, open.is_stopped);
    if (!is_resting) causes_.add(open.errors);
  }
  if (!resting_from_step) causes_.add(open_arcs_);
  open_arcs_ = {};
  open_contacts_.clear();
}

}  // namespace hyrax
