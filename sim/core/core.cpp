#include "sim/core/core.h"

#include <cmath>
#include <limits>

#include "sim/motion/step.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

std::string CoreRecord::checksum() const {
  const std::string_view text = step.empty() || is_named_by_header ? header : step;
  return text.empty() ? "" : hex(digest(std::as_bytes(std::span(text))));
}

std::string Core::sources() const {
  std::string walls;
  for (const Wall wall : kWalls)
    if (touches(walls_of_rows, wall)) walls.append(walls.empty() ? "" : ", ").append(name_of(wall));
  if (walls.empty()) return "";
  return walls_of_rows == kAllWalls ? "from the rows" : walls + " from the rows";
}

// Flies in the largest window there is, in which most flights meet no wall. One that meets a wall is repeated
// from the middle of the window, with the same velocity. There its velocities are right, and the distance
// flown is right up to the rounding of a coordinate near 1e9 px. Where it equals the listing's, new velocity
// times dt, up to that rounding, the listing's is used, which is exact.
State Core::flight(const State& body, double dt_s) const {
  constexpr int kSide_px = std::numeric_limits<int>::max();
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  const auto flown = [&](const State& from) { return step(from, dt_s, {kSide_px, kSide_px}); };
  const auto is_inside = [](double at_px) { return at_px > 0.0 && at_px < kSide_px; };
  State end = flown(body);
  if (is_inside(end.x_px) && is_inside(end.y_px)) return end;
  State way{0.0, 0.0, body.vx_px_per_s, body.vy_px_per_s};
  ListingStep(constants.value(), AllParts{}, Bounds{}).fly(way, dt_s);
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
