#include "sim/replay/core.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "sim/motion/step.h"
#include "sim/physics/physics.h"
#include "sim/replay/core_constants.h"

namespace hyrax {
namespace {

physics in(const State& body) { return {body.x_px, body.y_px, body.vx_px_per_s, body.vy_px_per_s}; }
State out(const physics& body) { return {body.x(), body.y(), body.vx(), body.vy()}; }

}  // namespace

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

State core_played(const State& body, std::span<const double> frames_s, const Bounds& bounds, int parts) {
  physics moving = in(body);
  const int right_px = static_cast<int>(bounds.right_px);
  const int bottom_px = static_cast<int>(bounds.bottom_px);
  if (parts == 1) {
    for (const double frame_s : frames_s) moving.update(frame_s, right_px, bottom_px, 0, 0);
  } else {
    for (const double frame_s : frames_s)
      for (int part = 0; part < parts; ++part) moving.update(frame_s / parts, right_px, bottom_px, 0, 0);
  }
  return out(moving);
}

State core_stopped(const State& body) {
  physics moving = in(body);
  moving.resetVelocity();
  return out(moving);
}

// In the largest window there is, most flights meet no wall. One that does flies again at the same velocity
// in the middle of the window: its speeds are those of the flight, and so is its distance, to the rounding of
// such a place. If that distance is speed times dt, as the listing moves, the position is exact; else to
// that rounding.
State core_flight(const State& body, double dt_s) {
  constexpr int kSide_px = std::numeric_limits<int>::max();
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  const auto flown = [dt_s](const State& from) {
    physics moving = in(from);
    moving.update(dt_s, kSide_px, kSide_px, 0, 0);
    return out(moving);
  };
  const auto is_inside = [](double at_px) { return at_px > 0.0 && at_px < kSide_px; };
  State end = flown(body);
  if (is_inside(end.x_px) && is_inside(end.y_px)) return end;
  State way{0.0, 0.0, body.vx_px_per_s, body.vy_px_per_s};
  ListingStep(core_constants(), AllParts{}, Bounds{}).fly(way, dt_s);
  const State middle{0.5 * kSide_px - way.x_px, 0.5 * kSide_px - way.y_px, body.vx_px_per_s,
                     body.vy_px_per_s};
  const State there = flown(middle);
  const auto moved = [&](double from_px, double distance_px, double listing_px) {
    const double rounding_px = kRounding * (kSide_px + std::fabs(listing_px));
    return from_px + (std::fabs(distance_px - listing_px) > rounding_px ? distance_px : listing_px);
  };
  if (!is_inside(end.x_px)) end.x_px = moved(body.x_px, there.x_px - middle.x_px, there.vx_px_per_s * dt_s);
  if (!is_inside(end.y_px)) end.y_px = moved(body.y_px, there.y_px - middle.y_px, there.vy_px_per_s * dt_s);
  return {end.x_px, end.y_px, there.vx_px_per_s, there.vy_px_per_s};
}

}  // namespace hyrax
