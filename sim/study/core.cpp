#include "sim/study/core.h"

#include "sim/physics/physics.h"

namespace hyrax {
namespace {

physics in(const Body& body) { return {body.x_px, body.y_px, body.vx_px_per_s, body.vy_px_per_s}; }
Body out(const physics& body) { return {body.x(), body.y(), body.vx(), body.vy()}; }

}  // namespace

CoreConstants core_constants() {
  return {.gravity_px_per_s2 = physics::GRAVITY,
          .restitution = physics::RESTITUTION,
          .air_drag = physics::AIR_DRAG,
          .ground_friction = physics::GROUND_FRICTION,
          .rest_threshold_px_per_s = physics::REST_THRESHOLD};
}

Body core_step(const Body& body, double dt_s, Bounds bounds) { return core_steps(body, dt_s, bounds, 1); }

Body core_steps(Body body, double dt_s, Bounds bounds, std::int64_t steps) {
  physics moving = in(body);
  for (std::int64_t step = 0; step < steps; ++step)
    moving.update(dt_s, bounds.right_px, bounds.bottom_px, 0, 0);
  return out(moving);
}

Body core_stopped(const Body& body) {
  physics moving = in(body);
  moving.resetVelocity();
  return out(moving);
}

Body core_flight(const Body& body, double dt_s) {
  physics moving = in(body);
  moving.fly(dt_s);
  return out(moving);
}

}  // namespace hyrax
