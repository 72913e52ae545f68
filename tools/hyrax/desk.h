// The part of the screen that the hyrax moves in, and its position there.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// A point of the screen, px; a monitor left of or above the main one has negative ones.
struct ScreenPoint {
  std::int32_t x_px = 0;
  std::int32_t y_px = 0;
  bool operator==(const ScreenPoint&) const = default;
};

/// The work area of a monitor, and the sprite's size on it. The model's coordinates are relative to `origin`.
struct Desk {
  ScreenPoint origin;
  Size work_area;
  Size sprite;
  bool operator==(const Desk&) const = default;
};

inline constexpr int kUsualDpi = 96;         ///< 100 %.
inline constexpr int kUsualSprite_px = 128;  ///< Side of the sprite at it.

/// The size of the sprite at a scaling.
[[nodiscard]] Size sprite_at(int dpi);

/// Frames per second on a display, 30 .. 240; 60 if its rate is unknown: 0 or 1.
[[nodiscard]] int frame_rate_hz(int display_hz);

/// The point of the screen nearest to a position; halves are rounded away from zero.
[[nodiscard]] ScreenPoint on_screen(const Desk& desk, const Position& position);

/// The inputs that move a hyrax at `position` from one desk to another: the new sizes and, if the origin
/// differs, the same point of the screen relative to the new one.
[[nodiscard]] std::vector<Action> inputs_of_move(const Desk& from, const Desk& to, const Position& position);

}  // namespace hyrax
