// The part of the screen that the hyrax moves in, and its position there.
#pragma once

#include <algorithm>
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

/// How a sprite in a window is shown on a desk: scaled down if the window is larger than the work area.
struct Shown {
  ScreenPoint at;
  Size sprite;
};
[[nodiscard]] Shown shown_on(const Desk& desk, Size window, Size sprite, const Position& position);

/// The corner nearest to `corner` at which no part of the sprite is outside the window, if it fits.
[[nodiscard]] inline Position inside(const Position& corner, Size window, Size sprite) {
  const auto within = [](double at_px, int side_px) {
    return std::max(0.0, std::min<double>(at_px, side_px));
  };
  return {within(corner.x_px, window.width_px - sprite.width_px),
          within(corner.y_px, window.height_px - sprite.height_px)};
}

/// Whether a sprite may be on that desk: it is one of a monitor, or of two that touch; see desk_of_way.
[[nodiscard]] bool is_one_of(const std::vector<Desk>& monitors, const Desk& desk);

/// The desk for the next frame of a sprite on `now` that moves from one position to another. Where two
/// monitors touch there is no wall: a sprite that crosses their border is on a desk of both, as wide or high
/// as the border, with the sprite's size unchanged; then on that of the other. `now` if no desk has all of
/// the sprite.
[[nodiscard]] Desk desk_of_way(const std::vector<Desk>& monitors, const Desk& now, const Position& from,
                               const Position& to);

/// The inputs that move a hyrax at `position` from one desk to another: the new sizes and, if the origin
/// differs, the same point of the screen relative to the new one.
[[nodiscard]] std::vector<Action> inputs_of_move(const Desk& from, const Desk& to, const Position& position);

}  // namespace hyrax
