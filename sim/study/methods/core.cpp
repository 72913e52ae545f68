#include "sim/study/methods/core.h"

#include <cassert>
#include <cmath>

#include "sim/physics/physics.h"

namespace hyrax {
namespace {

physics in(const State& body) { return {body.x_px, body.y_px, body.vx_px_per_s, body.vy_px_per_s}; }
State out(const physics& body) { return {body.x(), body.y(), body.vx(), body.vy()}; }

}  // namespace

Constants core_constants() {
  return {.gravity_px_per_s2 = physics::GRAVITY,
          .restitution = physics::RESTITUTION,
          .air_drag = physics::AIR_DRAG,
          .ground_friction = physics::GROUND_FRICTION,
          .rest_threshold_px_per_s = physics::REST_THRESHOLD};
}

State core_step(const State& body, double dt_s, const Bounds& bounds) {
  return core_steps(body, dt_s, bounds, 1);
}

State core_steps(State body, double dt_s, const Bounds& bounds, std::int64_t steps) {
  physics moving = in(body);
  assert(bounds.right_px == std::trunc(bounds.right_px) && bounds.bottom_px == std::trunc(bounds.bottom_px));
  const int right_px = static_cast<int>(bounds.right_px);
  const int bottom_px = static_cast<int>(bounds.bottom_px);
  for (std::int64_t step = 0; step < steps; ++step) moving.update(dt_s, right_px, bottom_px, 0, 0);
  return out(moving);
}

State core_stopped(const State& body) {
  physics moving = in(body);
  moving.resetVelocity();
  return out(moving);
}

State core_flight(const State& body, double dt_s) {
  physics moving = in(body);
  moving.fly(dt_s);
  return out(moving);
}

}  // namespace hyrax
