#include "sim/reference/enclosed_fling.h"

#include <algorithm>
#include <cmath>

namespace hyrax {
namespace {

constexpr int kImpactsMax = 10'000;
// Later than any row: a flight that has not met a wall by then does not.
constexpr double kEndless_s = 1e21;

Ball at_60_hz(double factor, const Model& model) { return minus_log(factor) * model.model_rate_hz; }

}  // namespace

EnclosedFling::EnclosedFling(const Model& model)
    : model_(model),
      drag_rate_per_s_(at_60_hz(model.air_drag, model)),
      friction_rate_per_s_(at_60_hz(model.ground_friction, model)) {}

void EnclosedFling::give_up(const char* why) {
  if (why_not_.empty()) why_not_ = why;
}

void EnclosedFling::start(const EnclosedState& motion, const Bounds& bounds, bool slides) {
  bounds_ = bounds;
  x_ = {{motion.x_px, motion.vx_px_per_s}, 0.0, 0.0};
  y_ = {{motion.y_px, motion.vy_px_per_s}, 0.0, model_.gravity_px_per_s2};
  const bool lies = motion.y_px.is_exactly(bounds.bottom_px) && motion.vy_px_per_s.is_exactly(0.0);
  slides_ = slides && lies && motion.x_px.low() >= 0.0 && motion.x_px.high() <= bounds.right_px;
  for (const Wall wall : kWalls) {
    const Ball past_px = seen_from(wall).from.position_px;
    if (past_px.low() > 0.0)
      bounce(wall, 0.0);
    else if (past_px.high() > 0.0)
      give_up("whether an input leaves the sprite beyond a wall");
  }
  find_next();
}

// displacement = v t phi1(z) + g t^2 phi2(z), speed = v + z phi1(z) v + g t phi1(z), with z = -k t.
EnclosedFling::Motion EnclosedFling::after(const Axis& axis, const Ball& since_s) const {
  const Ball z = -(rate_per_s() * since_s);
  const Phi<Ball> p = phi(z);
  const Ball& v = axis.from.speed_px_per_s;
  const Ball gain = since_s * axis.acceleration_px_per_s2;
  return {axis.from.position_px + since_s * (v * p.one + gain * p.two), v + z * p.one * v + gain * p.one};
}

std::optional<EnclosedState> EnclosedFling::at(const Ball& t_s) {
  while (why_not_.empty() && next_s_ && (t_s - *next_s_).low() > 0.0) {
    bounce(next_wall_, *next_s_);
    find_next();
  }
  if (!why_not_.empty()) return std::nullopt;
  const Motion x = after(x_, t_s - x_.from_s);
  const Motion y = slides_ ? y_.from : after(y_, t_s - y_.from_s);
  EnclosedState now;
  now.x_px = x.position_px;
  now.y_px = y.position_px;
  now.vx_px_per_s = x.speed_px_per_s;
  now.vy_px_per_s = y.speed_px_per_s;
  if (!next_s_ || (t_s - *next_s_).high() < 0.0) return now;
  // At the very time of an impact: before it, or after it as far as the sprite gets in what is not known.
  const double unsure_s = 4.0 * (t_s - *next_s_).magnitude();
  for (auto* const position : {&now.x_px, &now.y_px})
    position->radius += unsure_s * (now.vx_px_per_s.magnitude() + now.vy_px_per_s.magnitude() + 1.0);
  return now;
}

// Position and speed grow outwards, and past the wall the position is positive.
EnclosedFling::Axis EnclosedFling::seen_from(Wall wall) {
  const double outwards = wall == Wall::left || wall == Wall::top ? -1.0 : 1.0;
  Axis seen = axis_of(wall);
  seen.from.position_px = (seen.from.position_px - place_px(wall, bounds_)) * outwards;
  seen.from.speed_px_per_s = seen.from.speed_px_per_s * outwards;
  seen.acceleration_px_per_s2 *= outwards;
  return seen;
}

void EnclosedFling::find_next() {
  next_s_.reset();
  std::optional<Ball> second_s;
  for (const Wall wall : kWalls) {
    if (slides_ && !is_at_side(wall)) break;
    std::optional<Ball> found_s = impact(seen_from(wall));
    if (!found_s) continue;
    *found_s = axis_of(wall).from_s + *found_s;
    if (!next_s_ || (*found_s - *next_s_).mid.hi < 0.0) {
      std::swap(found_s, next_s_);
      next_wall_ = wall;
    }
    if (found_s && (!second_s || (*found_s - *second_s).mid.hi < 0.0)) second_s = found_s;
  }
  if (!second_s) return;
  const Ball apart_s = *second_s - *next_s_;
  if (apart_s.low() <= 0.0 && !apart_s.is_exactly(0.0)) give_up("which of two walls is met first");
}

// Since the axis began.
std::optional<Ball> EnclosedFling::impact(const Axis& seen) {
  const auto& [position_px, speed_px_per_s] = seen.from;
  const double slowest = speed_px_per_s.low();
  if (position_px.is_exactly(0.0) && slowest >= 0.0 && (slowest > 0.0 || seen.acceleration_px_per_s2 > 0.0))
    return Ball(0.0);
  const std::optional<Impact> near = time_of_impact({std::min(0.0, position_px.mid.hi), speed_px_per_s.mid.hi,
                                                     seen.acceleration_px_per_s2, rate_per_s().mid.hi},
                                                    kEndless_s);
  if (near) return enclosed_root(seen, near->t_s);
  if (!is_never_met(seen)) give_up("whether a wall is met at all");
  return std::nullopt;
}

// Newton's steps to 100 bits; then the root is within |position| / speed, where the speed outwards is at
// least half of what it is there. Before it there is no other: a flight comes from inside, and turns once at
// most.
std::optional<Ball> EnclosedFling::enclosed_root(const Axis& seen, double near_s) {
  Ball t_s = near_s;
  for (int step = 0; step < 3; ++step) {
    const Motion there = after(seen, t_s);
    if (there.speed_px_per_s.low() > 0.0)
      t_s = {t_s.mid + -(there.position_px.mid / there.speed_px_per_s.mid), 0.0, 0.0};
  }
  const Motion there = after(seen, t_s);
  const double slowest = there.speed_px_per_s.low();
  const double off_s = 2.0 * there.position_px.magnitude() / slowest;
  const double slows =
      std::fabs(seen.acceleration_px_per_s2) + rate_per_s().magnitude() * there.speed_px_per_s.magnitude();
  if (slowest > 0.0 && slows * off_s <= 0.4 * slowest && t_s.mid.hi - off_s > 0.0)
    return Ball(t_s.mid, off_s, 0.0);
  give_up("whether a wall is met or only touched");
  return std::nullopt;
}

// For certain. Upwards the position has its maximum where gravity has used up the speed: near there it is a
// parabola that bends by g at least.
bool EnclosedFling::is_never_met(const Axis& seen) const {
  const double a = seen.acceleration_px_per_s2;
  const Ball& v = seen.from.speed_px_per_s;
  if (a > 0.0) return false;
  if (v.high() <= 0.0) return true;
  if (a == 0.0) return v.low() > 0.0 && after(seen, kEndless_s).position_px.high() < 0.0;
  const double undamped_s = v.mid.hi / -a;
  const double damping = rate_per_s().mid.hi * undamped_s;
  const Motion apex = after(seen, damping > 0.0 ? undamped_s * (std::log1p(damping) / damping) : undamped_s);
  const double speed = apex.speed_px_per_s.magnitude();
  return apex.position_px.high() + speed * speed / -a < 0.0;
}

void EnclosedFling::bounce(Wall wall, const Ball& t_s) {
  if (++impacts_ > kImpactsMax) give_up("what comes after 10,000 impacts");
  const auto turn = [&](Axis& axis) {
    const Ball speed = after(axis, t_s - axis.from_s).speed_px_per_s * -model_.restitution;
    axis.from = {place_px(wall, bounds_), speed};
    axis.from_s = t_s;
  };
  if (is_at_side(wall)) {
    turn(x_);
    // Between two walls at one place it turns until nothing is left.
    if (bounds_.right_px == 0.0) x_.from.speed_px_per_s = 0.0;
    return;
  }
  turn(y_);
  if (wall == Wall::top) return;
  x_.from = after(x_, t_s - x_.from_s);
  x_.from.speed_px_per_s = x_.from.speed_px_per_s * model_.ground_friction;
  x_.from_s = t_s;
  Ball& speed = y_.from.speed_px_per_s;
  slides_ = speed.magnitude() < model_.rest_threshold_px_per_s;
  if (!slides_ && std::max(speed.low(), -speed.high()) < model_.rest_threshold_px_per_s)
    give_up("whether the sprite comes to rest");
  if (slides_) speed = 0.0;
}

}  // namespace hyrax
