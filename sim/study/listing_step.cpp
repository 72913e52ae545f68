#include "sim/study/listing_step.h"

#include <cmath>

#include "sim/scenario/split_mix64.h"
#include "sim/trajectory/row.h"

namespace hyrax {
namespace {

void pull(const CoreConstants& constants, Body& body, double dt_s) {
  body.vy_px_per_s += constants.gravity_px_per_s2 * dt_s;
}

void drag(const CoreConstants& constants, Body& body) {
  body.vx_px_per_s *= constants.air_drag;
  body.vy_px_per_s *= constants.air_drag;
}

void move(Body& body, double dt_s) {
  body.x_px += body.vx_px_per_s * dt_s;
  body.y_px += body.vy_px_per_s * dt_s;
}

void meet_walls_in_x(const CoreConstants& constants, Body& body, Bounds bounds) {
  const double right_px = bounds.right_px;
  if (!(body.x_px < 0.0) && !(body.x_px > right_px)) return;
  body.x_px = body.x_px < 0.0 ? 0.0 : right_px;
  body.vx_px_per_s = -body.vx_px_per_s * constants.restitution;
}

void meet_walls_in_y(const CoreConstants& constants, Body& body, Bounds bounds) {
  const double bottom_px = bounds.bottom_px;
  if (body.y_px < 0.0) {
    body.y_px = 0.0;
    body.vy_px_per_s = -body.vy_px_per_s * constants.restitution;
  } else if (body.y_px > bottom_px) {
    body.y_px = bottom_px;
    body.vy_px_per_s = -body.vy_px_per_s * constants.restitution;
    body.vx_px_per_s *= constants.ground_friction;
    if (std::fabs(body.vy_px_per_s) < constants.rest_threshold_px_per_s) body.vy_px_per_s = 0.0;
  }
}

bool same_state(const Body& a, const Body& b) {
  return same_bits(a.x_px, b.x_px) && same_bits(a.y_px, b.y_px) && same_bits(a.vx_px_per_s, b.vx_px_per_s) &&
         same_bits(a.vy_px_per_s, b.vy_px_per_s);
}

}  // namespace

Body listing_step(const CoreConstants& constants, StepOrder order, Body body, double dt_s, Bounds bounds) {
  if (order == StepOrder::position_first) move(body, dt_s);
  if (order == StepOrder::walls_first) {
    meet_walls_in_x(constants, body, bounds);
    meet_walls_in_y(constants, body, bounds);
  }
  if (order == StepOrder::drag_first) drag(constants, body);
  pull(constants, body, dt_s);
  if (order != StepOrder::drag_first) drag(constants, body);
  if (order != StepOrder::position_first) move(body, dt_s);
  if (order == StepOrder::walls_first) return body;
  if (order == StepOrder::y_walls_first) meet_walls_in_y(constants, body, bounds);
  meet_walls_in_x(constants, body, bounds);
  if (order != StepOrder::y_walls_first) meet_walls_in_y(constants, body, bounds);
  return body;
}

std::int64_t steps_unlike_listing(std::int64_t steps) {
  constexpr std::int64_t kStepsOfAFling = 500;
  constexpr std::int64_t kStepsInACorner = 25;
  constexpr Bounds kBounds{1792, 952};
  const auto corner_speed = [](std::int64_t step) {
    return 500.0 + 2000.0 * split_mix64_unit(815, static_cast<std::uint64_t>(step));
  };
  const CoreConstants constants = core_constants();
  std::int64_t unlike = 0;
  Body body;
  for (std::int64_t step = 0; step < steps; ++step) {
    if (step % kStepsOfAFling == 0) {
      const auto first = 4 * static_cast<std::uint64_t>(step);
      const auto draw = [first](std::uint64_t which) { return split_mix64_unit(4711, first + which); };
      body = {kBounds.right_px * draw(0), kBounds.bottom_px * draw(1), 6000.0 * (draw(2) - 0.5),
              6000.0 * (draw(3) - 0.5)};
    }
    // Every other fling is thrown into a corner again and again, so that both walls act in one step.
    if (step / kStepsOfAFling % 2 == 1 && step % kStepsInACorner == 1) {
      const double side = step % (2 * kStepsInACorner) == 1 ? 1.0 : 0.0;
      body = {side * kBounds.right_px, kBounds.bottom_px, (2.0 * side - 1.0) * corner_speed(step),
              corner_speed(step)};
    }
    // Some frames take no time: then a sprite on a bound has not passed it.
    const double drawn_dt_s = 0.03 * split_mix64_unit(1147, static_cast<std::uint64_t>(step));
    const double dt_s = step % 7 == 0 ? 0.0 : drawn_dt_s;
    const Body next = core_step(body, dt_s, kBounds);
    if (!same_state(next, listing_step(constants, StepOrder::paper, body, dt_s, kBounds))) ++unlike;
    body = next;
  }
  return unlike;
}

}  // namespace hyrax
