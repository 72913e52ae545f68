// The monitors, and the pointer on them.
#pragma once

#include <optional>

#include <windows.h>

#include "tools/hyrax/desk.h"

namespace hyrax {

struct Monitor {
  HMONITOR handle;
  Desk desk;
};

/// The monitor at the point, or the nearest one; without any, an arbitrary desk.
[[nodiscard]] Monitor monitor_under(ScreenPoint point);

/// Its current work area, and the size of the sprite at its scaling. Nothing if it was disconnected.
[[nodiscard]] std::optional<Desk> desk_of(HMONITOR monitor);

/// Frames per second, 30 .. 240; 60 if unknown.
[[nodiscard]] int refresh_hz(HMONITOR monitor);

/// The pointer when the current message was sent; it may have moved since.
[[nodiscard]] ScreenPoint pointer_of_message();
/// The pointer now. Nothing if the system refuses, as on a locked desktop.
[[nodiscard]] std::optional<ScreenPoint> pointer();
/// Whether the main button is pressed now.
[[nodiscard]] bool is_button_down();

}  // namespace hyrax
