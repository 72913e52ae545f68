#include "sim/reference/arc_meter.h"

#include <algorithm>
#include <cmath>

#include "sim/reference/drift.h"

namespace hyrax {
namespace {

// Of a sum of the arc's frames and the clamped one.
constexpr double kTimeRounding = 4e-16;
// Of a frame.
constexpr double kDragLittle = 0.002;

double squared(const Velocity& v) { return v.vx_px_per_s * v.vx_px_per_s + v.vy_px_per_s * v.vy_px_per_s; }

}  // namespace

ReferenceCheck::ReferenceCheck(const Model& model, FlightSolver& solver)
    : solver_(solver),
      gravity_(model.gravity_px_per_s2),
      drag_(-std::log(model.air_drag)),
      walls_(gravity_, -drag_, [&solver](const Approach& approach, double t_max_s) {
        return solver.time_of_impact(approach, t_max_s);
      }) {}

void ReferenceCheck::start(const ArcStart& start, bool solves_x, double energy_px2_per_s2) {
  last_ = {start.row.vx_px_per_s, start.row.vy_px_per_s};
  solver_.start(last_, solves_x);
  walls_.start(start);
  drag_taken_ = {};
  first_energy_ = energy_px2_per_s2;
  gathered_ = {};
  include_sizes(squared(last_), energy_px2_per_s2);
}

void ReferenceCheck::include_sizes(double speed_squared, double energy_px2_per_s2) {
  Gathered& g = gathered_;
  g.speed_largest_squared = larger(g.speed_largest_squared, speed_squared);
  g.energy_largest_px2_per_s2 = larger(g.energy_largest_px2_per_s2, std::fabs(energy_px2_per_s2));
}

// The integral of c v^2 over a frame, c = -ln(a). With little drag by the trapezium with corrected ends:
// f = v^2 bends so little in a frame that c^3 (a h)^2 / 50 is left out. With more by v' = g - k v itself,
// multiplied by v; with little its c ∫v = gh - (v1 - v0) has few digits.
double ReferenceCheck::drag_loss(const Velocity& from, const Velocity& to, double dt_s) const {
  const double gain = gravity_ * dt_s;
  const double from_2 = squared(from);
  const double to_2 = squared(to);
  if (drag_ > kDragLittle)
    return gain * ((gain - (to.vy_px_per_s - from.vy_px_per_s)) / drag_) - 0.5 * (to_2 - from_2);
  const double from_slope = 2.0 * (gain * from.vy_px_per_s - drag_ * from_2);
  const double to_slope = 2.0 * (gain * to.vy_px_per_s - drag_ * to_2);
  return drag_ * (0.5 * (from_2 + to_2) + (from_slope - to_slope) / 12.0);
}

void ReferenceCheck::check_row(const Closed& closed, double dt_s, double elapsed_s) {
  Gathered& g = gathered_;
  if (g.has_failed) return;
  const std::optional<State> solved = solver_.advance(dt_s);
  g.has_failed = !solved;
  if (!solved) return;
  g.position.add(solved->x_px - closed.flight.x_px, solved->y_px - closed.flight.y_px);
  g.velocity.add(solved->vx_px_per_s - closed.flight.vx_px_per_s,
                 solved->vy_px_per_s - closed.flight.vy_px_per_s);
  const Velocity now = velocity_of(*solved);
  drag_taken_ = drag_taken_ + drag_loss(last_, now, dt_s);
  const double gain = -drag_taken_.hi;
  g.energy_px2_per_s2 = larger(g.energy_px2_per_s2, std::fabs(closed.energy_gain_px2_per_s2 - gain));
  g.energy_px2_per_s2 =
      larger(g.energy_px2_per_s2, std::fabs((closed.energy_px2_per_s2 - first_energy_) - gain));
  include_sizes(squared(now), closed.energy_px2_per_s2);
  last_ = now;
  walls_.add(*solved, dt_s, elapsed_s);
  g.elapsed_s = elapsed_s;
}

void ReferenceCheck::check_model(const Position& displacement, double t_s) {
  if (gathered_.has_failed) return;
  const std::optional<Position> solved = solver_.model(t_s);
  gathered_.has_failed = !solved;
  if (solved) gathered_.model.add(solved->x_px - displacement.x_px, solved->y_px - displacement.y_px);
}

// A time by itself is worth nothing where a wall is only grazed; times the speed it is a distance. So is
// how far one solution goes past a wall that the other does not reach: through v^2 / 2g of height, or in
// the time that was left.
void ReferenceCheck::check_impact(Wall wall, double clamped_dt_s, const std::optional<Impact>& closed) {
  Gathered& g = gathered_;
  if (g.has_failed) return;
  const std::optional<Impact> solved = walls_.impact(wall, clamped_dt_s);
  if (closed && solved) {
    const double rounding_s = kTimeRounding * (g.elapsed_s + clamped_dt_s);
    const double apart_s = larger(0.0, std::fabs(closed->t_s - solved->t_s) - rounding_s);
    const double speed = larger(closed->speed_px_per_s, solved->speed_px_per_s);
    include_flown(*solved);
    g.impact_px = larger(g.impact_px, apart_s * speed);
    const double gained = (gravity_ + closed->drag_rate_per_s * speed) * (apart_s + rounding_s);
    g.impact_px_per_s =
        larger(g.impact_px_per_s, std::fabs(closed->speed_px_per_s - solved->speed_px_per_s) - gained);
  } else if (closed || solved) {
    const Impact& one = closed ? *closed : *solved;
    const double left_s = walls_.time_max_s(clamped_dt_s) - one.t_s;
    const double speed = one.speed_px_per_s;
    include_flown(one);
    g.impact_px = larger(g.impact_px, speed * std::min(left_s, speed / (2.0 * gravity_)));
  }
}

// Between the last row and the wall, coordinates may be larger than those of all rows.
void ReferenceCheck::include_flown(const Impact& impact) {
  const double speed = larger(std::sqrt(squared(last_)), std::fabs(impact.speed_px_per_s));
  gathered_.flown_px = larger(gathered_.flown_px, speed * std::max(impact.t_s, 0.0));
}

std::optional<double> ReferenceCheck::apart_px() const {
  if (gathered_.has_failed) return std::nullopt;
  return larger(gathered_.position.value(), gathered_.model.value());
}

std::string_view ReferenceCheck::fault(double coordinate_largest_px) const {
  const Gathered& g = gathered_;
  if (g.has_failed) return "the second solver failed";
  const double px_max = kSolversApart_px + kSolversApart_rel * coordinate_largest_px;
  const double speed_largest_px_per_s = std::sqrt(g.speed_largest_squared);
  const double px_per_s_max = kSolversApart_px_per_s + kSolversApart_rel * speed_largest_px_per_s;
  const double energy_scale =
      kSolversApartEnergyMin_px2_per_s2 + g.speed_largest_squared + g.energy_largest_px2_per_s2;
  if (!(g.position.value() <= px_max)) return "position differs";
  if (!(g.velocity.value() <= px_per_s_max)) return "velocity differs";
  if (!(g.model.value() <= px_max)) return "model error differs";
  if (!(g.energy_px2_per_s2 <= kSolversApartEnergy_rel * energy_scale)) return "energy differs";
  const double impact_px_max = px_max + kSolversApart_rel * g.flown_px;
  if (!(g.impact_px <= impact_px_max && g.impact_px_per_s <= px_per_s_max)) return "time of impact differs";
  return {};
}

}  // namespace hyrax
