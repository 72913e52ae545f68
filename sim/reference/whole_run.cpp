#include "sim/reference/whole_run.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace hyrax {
namespace {

// No run is longer: 1e12 frames of kFrameMax_s.
constexpr double kLongestRun_s = 1e21;
// Far less than a row can hold of a coordinate in a window.
constexpr double kStill_px = 1e-12;

bool is_factor(double factor) { return factor > 0.0 && factor <= 1.0; }

}  // namespace

std::string why_no_exact_fling(const Model& model) {
  if (!(model.gravity_px_per_s2 > 0.0)) return "gravity is 0";
  if (!is_factor(model.air_drag)) return "the drag factor is not above 0 and at most 1";
  if (!is_factor(model.ground_friction)) return "the friction factor is not above 0 and at most 1";
  if (!(model.restitution >= 0.0 && model.restitution <= 1.0)) return "the restitution is not 0 to 1";
  if (!(model.rest_threshold_px_per_s > 0.0)) return "the rest threshold is 0";
  return "";
}

WholeMeter::WholeMeter(const Scenario& scenario, std::vector<Input> inputs, const Model& model,
                       std::function<void(const WholeRow&)> each, bool encloses)
    : playback_(scenario, std::move(inputs)),
      laws_(model),
      fling_(laws_),
      steps_(step_count(scenario)),
      each_(std::move(each)) {
  if (std::string why = why_no_exact_fling(model); !why.empty()) {
    end_without(std::move(why));
    return;
  }
  outcome_.run.emplace();
  if (!encloses) return;
  enclosed_.emplace(model);
  outcome_.run->end_px_low = outcome_.run->end_px_high = outcome_.run->max_px_low =
      outcome_.run->max_px_high = 0.0;
}

void WholeMeter::end_without(std::string why, bool is_fault) {
  outcome_ = {.run = std::nullopt, .why_not = std::move(why), .is_fault = is_fault, .enclosure_why = ""};
  is_over_ = true;
}

void WholeMeter::row(const Row& row) {
  if (is_over_) return;
  if (!is_finite(state_of(row)))
    return end_without("a value is not finite from row " + std::to_string(row.step));
  if (row.step == 0) {
    exact_ = state_of(row);
  } else {
    if (!playback_.is_held() && !still_from_step_) exact_ = fling_.at(row.t_s - from_s_);
    const auto up_to_here = [&row](const char* what) {
      return what + (" in row " + std::to_string(row.step));
    };
    if (!fling_.is_sound()) return end_without(up_to_here("the exact fling is outside its bounds"), true);
    if (fling_.is_cut()) return end_without(up_to_here("the exact fling has met a million walls"));
    compare(row);
  }
  last_ = row;
  Row from = row;
  set_state(from, exact_);
  if (playback_.has_inputs_after(row.step)) end_stretch();
  const InputChange change = playback_.apply(from);
  if (change.sets_velocity) ahead_ = {};
  if (change.ends_arc || row.step == 0) start(from, change);
  // The state repeats itself to the end, without inputs: the last row is as this one.
  is_over_ = is_over_ || (still_from_step_ && repetition_ && repetition_->from_step <= row.step &&
                          row.step - *still_from_step_ >= repetition_->period_steps &&
                          (steps_ - row.step) % repetition_->period_steps == 0);
}

void WholeMeter::start(const Row& from, const InputChange& change) {
  const Bounds bounds = playback_.bounds();
  if (!(bounds.right_px >= 0.0 && bounds.bottom_px >= 0.0))
    return end_without("the sprite is larger than its window in row " + std::to_string(from.step));
  exact_ = state_of(from);
  from_s_ = from.t_s;
  if (enclosed_) {
    const EnclosedState set(exact_);
    if (still_from_step_) within_.x_px.radius += kStill_px;
    if (from.step == 0 || change.sets_position)
      std::tie(within_.x_px, within_.y_px) = std::tie(set.x_px, set.y_px);
    if (from.step == 0 || change.sets_velocity)
      std::tie(within_.vx_px_per_s, within_.vy_px_per_s) = std::tie(set.vx_px_per_s, set.vy_px_per_s);
    enclosed_->start(within_, bounds, from.step > 0 && enclosed_->slides());
  }
  fling_.start(exact_, bounds, from.step > 0 && fling_.slides(), kLongestRun_s);
  still_from_step_.reset();
  met_.clear();
  compared_ = counted_ = 0;
  contact_before_ = 0;
}

// Distances of the row from all that lies within the balls. From where the exact fling is in its place, it
// moves by no more than kStill_px.
void WholeMeter::enclose(const Row& row) {
  if (!playback_.is_held() && !still_from_step_) {
    const std::optional<EnclosedState> within = enclosed_->at(Ball(row.t_s) - from_s_);
    if (within) within_ = *within;
  }
  WholeRun& whole = *outcome_.run;
  outcome_.enclosure_why = enclosed_->why_not();
  if (!outcome_.enclosure_why.empty()) {
    whole.end_px_low = whole.end_px_high = whole.max_px_low = whole.max_px_high = std::nullopt;
    return;
  }
  constexpr double kRoundings = 1e-15;
  double low_squared = 0.0, high_squared = 0.0;
  for (const Ball& apart : {within_.x_px - row.x_px, within_.y_px - row.y_px}) {
    const double nearest = std::max({0.0, apart.low(), -apart.high()}) - (still_from_step_ ? kStill_px : 0.0);
    const double farthest = std::max(-apart.low(), apart.high()) + (still_from_step_ ? kStill_px : 0.0);
    low_squared += std::max(0.0, nearest) * std::max(0.0, nearest);
    high_squared += farthest * farthest;
  }
  whole.end_px_low = std::sqrt(low_squared) * (1.0 - kRoundings);
  whole.end_px_high = std::sqrt(high_squared) * (1.0 + kRoundings);
  whole.max_px_low = std::max(*whole.max_px_low, *whole.end_px_low);
  whole.max_px_high = std::max(*whole.max_px_high, *whole.end_px_high);
}

void WholeMeter::end_stretch() {
  resting_.end(last_.step);
  settle_energies(resting_.from_step().has_value());
}

WholeOutcome WholeMeter::finish() {
  if (outcome_.run) end_stretch();
  return outcome_;
}

void WholeMeter::compare(const Row& row) {
  WholeRun& whole = *outcome_.run;
  const double dx_px = row.x_px - exact_.x_px;
  const double dy_px = row.y_px - exact_.y_px;
  whole.end_px = std::hypot(dx_px, dy_px);
  if (whole.end_px > whole.max_px) {
    whole.max_px = whole.end_px;
    whole.max_px_step = row.step;
  }
  // Two large energies are never subtracted: (v - w)(v + w) / 2 - g (y - z).
  const auto half_difference = [](double v, double w) { return 0.5 * (v - w) * (v + w); };
  whole.energy_end_px = (half_difference(row.vx_px_per_s, exact_.vx_px_per_s) +
                         half_difference(row.vy_px_per_s, exact_.vy_px_per_s)) /
                            laws_.gravity_px_per_s2 -
                        dy_px;
  if (enclosed_) enclose(row);
  compare_contacts(row);
  compare_energies(row);
  if (each_ && !resting_.open_from_step()) each_({row.t_s, whole.end_px});
  const double still_px_per_s = kStill_px * (laws_.drag_rate_per_s + laws_.friction_rate_per_s);
  if (still_from_step_ || !fling_.slides() || std::fabs(exact_.vx_px_per_s) > still_px_per_s) return;
  exact_.vx_px_per_s = 0.0;
  still_from_step_ = row.step;
}

void WholeMeter::compare_energies(const Row& row) {
  WholeRun& whole = *outcome_.run;
  resting_.row(row.step, last_.contact, row.contact, row.y_px, playback_.bounds().bottom_px);
  const double apart_px = std::fabs(whole.energy_end_px);
  double& largest_px = ahead_ != WallCounts{}      ? whole.energy_phase_px
                       : resting_.open_from_step() ? open_energy_max_px_
                                                   : whole.energy_max_px;
  largest_px = std::max(largest_px, apart_px);
  if (!resting_.open_from_step()) settle_energies(false);
}

// Of rows near the floor, once it is known whether they were those of a resting contact.
void WholeMeter::settle_energies(bool are_resting) {
  WholeRun& whole = *outcome_.run;
  double& largest_px = are_resting ? whole.energy_phase_px : whole.energy_max_px;
  largest_px = std::max(largest_px, std::exchange(open_energy_max_px_, 0.0));
}

// In a corner the run's two contacts are one row's: their order is the exact fling's.
void WholeMeter::compare_contacts(const Row& row) {
  const std::vector<ExactImpact>& exact = fling_.impacts();
  for (const Wall wall : kWalls) {
    if (!touches(row.contact, wall)) continue;
    if (!touches(contact_before_, wall)) met_.push_back({row.step, wall});
    if (!touches(last_.contact, wall)) ++ahead_[wall];
  }
  for (; counted_ < exact.size(); ++counted_) --ahead_[exact[counted_].wall];
  contact_before_ = row.contact;
  if (outcome_.run->contacts_differ_from) return;
  std::size_t count = exact.size();  // Of those up to the one with which it slides.
  while (fling_.slides() && count > 0 && exact[count - 1].wall != Wall::ground) --count;
  for (; compared_ < std::min(met_.size(), count); ++compared_) {
    const std::size_t next = compared_ + 1;
    if (met_[compared_].wall != exact[compared_].wall && next < met_.size() &&
        met_[next].step == met_[compared_].step)
      std::swap(met_[compared_], met_[next]);
    if (met_[compared_].wall == exact[compared_].wall) continue;
    outcome_.run->contacts_differ_from = met_[compared_].step;
    return;
  }
}

}  // namespace hyrax
