// A monitor as the system has it at this moment.
#pragma once

#include <optional>

#include <windows.h>

#include "tools/hyrax/desk.h"

namespace hyrax {

/// Its work area, and the sprite in the size that its scaling asks for. Nothing if it is gone.
[[nodiscard]] std::optional<Desk> desk_of(HMONITOR monitor);

/// The monitor that holds the point, or the nearest one.
[[nodiscard]] HMONITOR monitor_at(ScreenPoint point);

/// Frames per second, 60 if the system does not know; 30 .. 240.
[[nodiscard]] int refresh_hz(HMONITOR monitor);

}  // namespace hyrax
