// A horizontal speed that is stuck: subnormal, changed by no step, and too slow to move the sprite.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/kernel.h"

namespace hyrax {

/// Left alone on the ground, vx shrinks until rounding gives back what drag and friction take: it stays at
/// 1e-323 px/s (two units of the last place), and arithmetic with such numbers costs some processors up
/// to 75 times as much.
///
/// Whether no frame of the stretch changes the bits of vx or x by the listing's step, whatever y does: drag
/// keeps vx, with the ground's friction and without; the longest frame does not move x, so no shorter one
/// does, since rounding is monotonic; and x is within its bounds, so no wall in x acts. Then the listing
/// gives x, y and vy the same bits with a zero of vx's sign in its place.
[[nodiscard]] inline bool has_stuck_vx(const Stretch& stretch, const State& body,
                                       const Constants& constants) {
  const double vx = body.vx_px_per_s;
  if (vx == 0.0 || !(std::fabs(vx) < std::numeric_limits<double>::min()) || stretch.is_held) return false;
  const double dragged = vx * constants.air_drag;
  if (dragged != vx || dragged * constants.ground_friction != vx) return false;
  const double right_px = bounds_of(stretch.window, stretch.sprite).right_px;
  if (!(body.x_px >= 0.0 && body.x_px <= right_px)) return false;
  const auto [least, most] =
      std::minmax_element(stretch.dt_s, stretch.dt_s + (stretch.is_dt_fixed ? 1 : stretch.frames));
  return *least >= 0.0 && same_bits(body.x_px + vx * *most, body.x_px);
}

}  // namespace hyrax
