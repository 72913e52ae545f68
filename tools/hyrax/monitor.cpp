#include "tools/hyrax/window.h"

#include <shellscalingapi.h>

namespace hyrax {

std::optional<Desk> desk_of(HMONITOR monitor) {
  MONITORINFO info{};
  info.cbSize = sizeof info;
  if (GetMonitorInfoW(monitor, &info) == 0) return std::nullopt;
  UINT dpi_x = kUsualDpi;
  UINT dpi_y = kUsualDpi;
  if (FAILED(GetDpiForMonitor(monitor, MDT_EFFECTIVE_DPI, &dpi_x, &dpi_y))) dpi_y = kUsualDpi;
  const RECT& area = info.rcWork;
  return Desk{
      {static_cast<std::int32_t>(area.left), static_cast<std::int32_t>(area.top)},
      {static_cast<std::int32_t>(area.right - area.left), static_cast<std::int32_t>(area.bottom - area.top)},
      sprite_at(static_cast<int>(dpi_y))};
}

Monitor monitor_under(ScreenPoint point) {
  constexpr Desk kNoScreen{
      {0, 0}, {1024, 768}, {kUsualSprite_px, kUsualSprite_px}};  // No window can be created then.
  const HMONITOR handle = MonitorFromPoint({point.x_px, point.y_px}, MONITOR_DEFAULTTONEAREST);
  return {handle, desk_of(handle).value_or(kNoScreen)};
}

int refresh_hz(HMONITOR monitor) {
  MONITORINFOEXW info{};
  info.cbSize = sizeof info;
  DEVMODEW mode{};
  mode.dmSize = sizeof mode;
  if (GetMonitorInfoW(monitor, &info) == 0 ||
      EnumDisplaySettingsW(info.szDevice, ENUM_CURRENT_SETTINGS, &mode) == 0)
    return frame_rate_hz(0);
  return frame_rate_hz(static_cast<int>(mode.dmDisplayFrequency));
}

ScreenPoint pointer_of_message() {
  const DWORD place = GetMessagePos();
  return {static_cast<std::int16_t>(LOWORD(place)), static_cast<std::int16_t>(HIWORD(place))};
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
