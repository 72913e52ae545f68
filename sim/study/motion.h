// A body in its room: what every method of a study moves.
#pragma once

#include "sim/scenario/scenario.h"

namespace hyrax {

/// Top left corner and velocity of the sprite; y grows downwards.
struct Motion {
  double x_px = 0.0;
  double y_px = 0.0;
  double vx_px_per_s = 0.0;
  double vy_px_per_s = 0.0;
};

/// The corner is kept within 0 .. window - sprite.
struct Room {
  Size window;
  Size sprite;
  [[nodiscard]] double right_px() const { return static_cast<double>(window.width_px - sprite.width_px); }
  [[nodiscard]] double bottom_px() const { return static_cast<double>(window.height_px - sprite.height_px); }
};

}  // namespace hyrax
