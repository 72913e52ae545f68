#include "sim/reference/exact_fling.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace hyrax {

bool slides_on(const State& motion, const Bounds& bounds) {
  return motion.y_px == bounds.bottom_px && motion.vy_px_per_s == 0.0 && motion.x_px >= 0.0 &&
         motion.x_px <= bounds.right_px;
}

void ExactFling::start(const State& motion, const Bounds& bounds, bool slides, double until_s) {
  assert(bounds.right_px >= 0.0 && bounds.bottom_px >= 0.0);
  bounds_ = bounds;
  from_ = motion;
  from_s_ = 0.0;
  slides_ = slides && slides_on(motion, bounds);
  until_s_ = until_s;
  is_sound_ = true;
  impacts_.clear();
  for (const Wall wall : kWalls)
    if (seen_from(wall).position_px > 0.0) bounce(wall);
  find_next();
}

Approach ExactFling::seen_from(Wall wall) const {
  return approach_to(wall, place_px(wall, bounds_), from_, laws_.gravity_px_per_s2, rate_per_s());
}

State ExactFling::at(double t_s) {
  const auto since_s = [&] { return std::max(0.0, t_s - from_s_); };
  assert(t_s >= from_s_ && t_s <= until_s_);
  while (since_s() >= next_s_ && !is_cut()) meet_walls();
  return is_cut() ? from_ : fly(since_s());
}

State ExactFling::fly(double since_s) {
  const AxisMotion x = hyrax::fly(from_.vx_px_per_s, 0.0, rate_per_s(), since_s);
  State now{from_.x_px + x.displacement_px, from_.y_px, x.speed_px_per_s, 0.0};
  keep_inside(now.x_px, bounds_.right_px);
  if (slides_) return now;
  const AxisMotion y = hyrax::fly(from_.vy_px_per_s, laws_.gravity_px_per_s2, rate_per_s(), since_s);
  now.y_px += y.displacement_px;
  now.vy_px_per_s = y.speed_px_per_s;
  keep_inside(now.y_px, bounds_.bottom_px);
  return now;
}

// Rounding puts a sprite past a wall that it is about to meet, by 1e-14 of its way or so; no further.
void ExactFling::keep_inside(double& position_px, double far_px) {
  constexpr double kRounding = 1e-12;
  const double inside_px = std::clamp(position_px, 0.0, far_px);
  is_sound_ = is_sound_ && std::fabs(position_px - inside_px) <= kRounding * (1.0 + far_px);
  position_px = inside_px;
}

void ExactFling::find_next() {
  next_s_ = std::numeric_limits<double>::infinity();
  for (const Wall wall : kWalls) {
    if (slides_ && !is_at_side(wall)) return;
    const auto impact = time_of_impact(seen_from(wall), until_s_ - from_s_);
    if (!impact || impact->t_s >= next_s_) continue;
    next_s_ = impact->t_s;
    next_wall_ = wall;
  }
}

// In a corner the other wall is met at this time, too, or by rounding was met an ulp of it ago: then the
// sprite is on it and moves outwards.
void ExactFling::meet_walls() {
  from_ = fly(next_s_);
  from_s_ += next_s_;
  for (const Wall wall : kWalls) {
    const Approach approach = seen_from(wall);
    if (wall == next_wall_ || (approach.position_px >= 0.0 && approach.speed_px_per_s > 0.0)) bounce(wall);
  }
  find_next();
}

// A subnormal speed times a factor above 1/2 can stay what it is: between two walls at one place it would
// turn for ever.
void ExactFling::turn(double& speed_px_per_s) const {
  speed_px_per_s *= -laws_.restitution;
  if (std::fabs(speed_px_per_s) < std::numeric_limits<double>::min()) speed_px_per_s = 0.0;
}

void ExactFling::bounce(Wall wall) {
  impacts_.push_back({from_s_, wall});
  (is_at_side(wall) ? from_.x_px : from_.y_px) = place_px(wall, bounds_);
  if (is_at_side(wall)) return turn(from_.vx_px_per_s);
  turn(from_.vy_px_per_s);
  if (wall == Wall::top) return;
  from_.vx_px_per_s *= laws_.ground_friction;
  slides_ = std::fabs(from_.vy_px_per_s) < laws_.rest_threshold_px_per_s;
  if (slides_) from_.vy_px_per_s = 0.0;
}

}  // namespace hyrax
