#include "sim/reference/margin.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/reference/flight.h"
#include "sim/reference/largest.h"
#include "sim/trajectory/row.h"

namespace hyrax {
namespace {

// A slope or a speed of this size decides nothing any more: a decision would have to lie nearer than
// any double. It is dropped, so that a long rest does not crawl through subnormal numbers.
constexpr double kGone = 1e-200;

double or_gone(double value) { return std::fabs(value) < kGone ? 0.0 : value; }

double scaled(double value, double factor) { return or_gone(value * factor); }

// Of a bound, a whole number.
double half_ulp(double bound_px) {
  return 0.5 * (std::nextafter(bound_px, std::numeric_limits<double>::infinity()) - bound_px);
}

double sign_of(double value) { return value == 0.0 ? 0.0 : std::copysign(1.0, value); }

}  // namespace

MarginMeter::MarginMeter(const Scenario& scenario, std::vector<Input> inputs, const Model& model)
    : playback_(scenario, std::move(inputs)),
      model_(model),
      half_width_(std::numeric_limits<double>::infinity()) {}

// In a state that repeats, no decision comes nearer except by what a change of the start still moves; in so
// many steps air drag alone reduces that to 2e-9.
void MarginMeter::repeats(const Repetition& repetition) {
  constexpr std::int64_t kStepsUntilStartIsForgotten = 20'000;
  last_decisive_step_ = repetition.from_step + 2 * repetition.period_steps + kStepsUntilStartIsForgotten;
}

void MarginMeter::row(const Row& row) {
  has_ended_ = has_ended_ || !is_finite(state_of(row)) || row.step > last_decisive_step_;
  if (has_ended_) return;
  if (row.step > 0 && !playback_.is_held()) step_to(row);
  last_ = row;
  const InputChange change = playback_.apply(last_);
  if (change.sets_position) x_.position = y_.position = {};
  if (change.sets_velocity) x_.speed_by_speed = y_.speed_by_speed = 0.0;
}

void MarginMeter::step_to(const Row& row) {
  const Unclamped x = fly(x_, last_.x_px, last_.vx_px_per_s, 0.0, row.dt_s);
  const Unclamped y = fly(y_, last_.y_px, last_.vy_px_per_s, model_.gravity_px_per_s2, row.dt_s);
  decide_walls(row, Wall::left, Wall::right, x_, x);
  decide_walls(row, Wall::top, Wall::ground, y_, y);
  if (row.contact != 0) clamp(row, y.speed_px_per_s);
}

// v' = a (v + g h), p' = p + h v', and the same without g for the slopes.
MarginMeter::Unclamped MarginMeter::fly(Axis& axis, double position_px, double speed_px_per_s,
                                        double acceleration_px_per_s2, double dt_s) const {
  axis.speed_by_speed *= model_.air_drag;
  axis.position.by_speed += dt_s * axis.speed_by_speed;
  const double speed = scaled(or_gone(speed_px_per_s) + acceleration_px_per_s2 * dt_s, model_.air_drag);
  return {position_px, speed * dt_s, speed};
}

// The listing asks for the wall at 0 first, and for the far one only where that did not clamp. The
// far one clamps what comes out beyond it after rounding, so by more than half a unit in its last
// place; next to 0 nothing is rounded away.
void MarginMeter::decide_walls(const Row& row, Wall near, Wall far, const Axis& axis, const Unclamped& step) {
  const auto decision = [](Wall wall) { return static_cast<Decision>(wall_index(wall)); };
  const bool is_near = touches(row.contact, near);
  consider(decision(near), row, is_near, step.from_px + step.move_px, 1.0, axis.position);
  if (is_near) return;
  const double far_px = place_px(far, playback_.bounds());
  const double inside_px = ((far_px - step.from_px) + half_ulp(far_px)) - step.move_px;
  // On the far wall rounding takes away whatever does not clamp: a step put the sprite there, and what
  // changes the decision is the speed of this step alone.
  const bool is_on_far = step.from_px == far_px && last_.step > 0;
  const Slope slope = is_on_far ? Slope{0.0, row.dt_s * axis.speed_by_speed} : axis.position;
  consider(decision(far), row, touches(row.contact, far), inside_px, -1.0, slope);
}

void MarginMeter::clamp(const Row& row, double vy_unclamped_px_per_s) {
  const auto turn = [this](Axis& axis) {
    axis.position = {};
    axis.speed_by_speed = scaled(axis.speed_by_speed, -model_.restitution);
  };
  if (touches(row.contact, Wall::left) || touches(row.contact, Wall::right)) turn(x_);
  if (touches(row.contact, Wall::top)) turn(y_);
  if (!touches(row.contact, Wall::ground)) return;
  turn(y_);
  x_.speed_by_speed = scaled(x_.speed_by_speed, model_.ground_friction);

  const double vy = -vy_unclamped_px_per_s * model_.restitution;
  const bool is_stopped = (row.contact & kRestBit) != 0;
  const double above = std::fabs(vy) - model_.rest_threshold_px_per_s;
  consider(Decision::rest, row, is_stopped, above, std::copysign(1.0, vy), {0.0, y_.speed_by_speed});
  if (is_stopped) y_.speed_by_speed = 0.0;
}

// @param value that decides: it falls otherwise beyond 0, below which it is taken; @param sign of its change
// with the quantity whose slope is given.
void MarginMeter::consider(Decision decision, const Row& row, bool is_taken, double value, double sign,
                           const Slope& slope) {
  const double steepness = std::fabs(slope.by_position) + std::fabs(slope.by_speed);
  if (steepness == 0.0) return;
  // As quotients: a product would be nearer, by its rounding, in each of many steps that decide alike.
  const double half_width = std::max(0.0, is_taken ? -value : value) / steepness;
  if (!(half_width < half_width_)) return;
  half_width_ = half_width;
  nearest_ = {decision, row.step, is_taken, {}};
  const std::size_t axis = decision <= Decision::right ? 0 : 1;
  const double towards = is_taken ? sign : -sign;
  nearest_.towards[axis] = towards * sign_of(slope.by_position);
  nearest_.towards[axis + 2] = towards * sign_of(slope.by_speed);
}

Margin MarginMeter::margin() const {
  Margin margin;
  if (std::isfinite(half_width_)) {
    margin.half_width = half_width_;
    margin.nearest = nearest_;
  }
  const std::array<const Axis*, 2> axes = {&x_, &y_};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Axis& a = *axes[axis];
    margin.sensitivity[axis][axis] = a.position.by_position;
    margin.sensitivity[axis][axis + 2] = a.position.by_speed;
    margin.sensitivity[axis + 2][axis + 2] = a.speed_by_speed;
  }
  for (const auto& row : margin.sensitivity) {
    double sum = 0.0;
    for (const double entry : row) sum += std::fabs(entry);
    margin.sensitivity_norm = larger(margin.sensitivity_norm, sum);
  }
  return margin;
}

}  // namespace hyrax
