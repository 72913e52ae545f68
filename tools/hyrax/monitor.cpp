#include "tools/hyrax/window.h"

#include <shellscalingapi.h>

namespace hyrax {

namespace {

constexpr Desk kNoScreen{
    {0, 0}, {1024, 768}, {kUsualSprite_px, kUsualSprite_px}};  // No window can be created then.

HMONITOR monitor_at(ScreenPoint point) {
  return MonitorFromPoint({point.x_px, point.y_px}, MONITOR_DEFAULTTONEAREST);
}

Desk desk_of(HMONITOR monitor) {
  MONITORINFO info{};
  info.cbSize = sizeof info;
  if (GetMonitorInfoW(monitor, &info) == 0) return kNoScreen;
  UINT dpi_x = kUsualDpi;
  UINT dpi_y = kUsualDpi;
  if (FAILED(GetDpiForMonitor(monitor, MDT_EFFECTIVE_DPI, &dpi_x, &dpi_y))) dpi_y = kUsualDpi;
  const RECT& area = info.rcWork;
  return {
      {static_cast<std::int32_t>(area.left), static_cast<std::int32_t>(area.top)},
      {static_cast<std::int32_t>(area.right - area.left), static_cast<std::int32_t>(area.bottom - area.top)},
      sprite_at(static_cast<int>(dpi_y))};
}

}  // namespace

std::vector<Desk> all_desks() {
  std::vector<Desk> desks;
  const auto add = [](HMONITOR monitor, HDC, RECT*, LPARAM to) -> BOOL {
    reinterpret_cast<std::vector<Desk>*>(to)->push_back(desk_of(monitor));
    return TRUE;
  };
  EnumDisplayMonitors(nullptr, nullptr, add, reinterpret_cast<LPARAM>(&desks));
  return desks;
}

Desk desk_under(ScreenPoint point) { return desk_of(monitor_at(point)); }

int refresh_hz(ScreenPoint point) {
  MONITORINFOEXW info{};
  info.cbSize = sizeof info;
  DEVMODEW mode{};
  mode.dmSize = sizeof mode;
  if (GetMonitorInfoW(monitor_at(point), &info) == 0 ||
      EnumDisplaySettingsW(info.szDevice, ENUM_CURRENT_SETTINGS, &mode) == 0)
    return frame_rate_hz(0);
  return frame_rate_hz(static_cast<int>(mode.dmDisplayFrequency));
}

ScreenPoint pointer_of_message() {
  const DWORD place = GetMessagePos();
  return {static_cast<std::int16_t>(LOWORD(place)), static_cast<std::int16_t>(HIWORD(place))};
}

// The system's own ticks are as long as 16 ms, so that a younger message is of now.
std::int64_t ticks_of_message() {
  constexpr std::int64_t kResolution_ms = 16;
  const std::int64_t age_ms =
      static_cast<std::int32_t>(GetTickCount() - static_cast<DWORD>(GetMessageTime()));
  return clock_ticks() - (age_ms > kResolution_ms ? age_ms * clock_ticks_per_s() / 1000 : 0);
}

std::optional<ScreenPoint> pointer() {
  POINT place{};
  if (GetCursorPos(&place) == 0) return std::nullopt;
  return ScreenPoint{static_cast<std::int32_t>(place.x), static_cast<std::int32_t>(place.y)};
}

bool is_button_down() {
  const bool is_left_handed = GetSystemMetrics(SM_SWAPBUTTON) != 0;
  return GetAsyncKeyState(is_left_handed ? VK_RBUTTON : VK_LBUTTON) < 0;
}

}  // namespace hyrax
