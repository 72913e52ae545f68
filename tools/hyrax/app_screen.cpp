// What the program does when the screen changes, another monitor becomes the hyrax's, or the machine sleeps.
#include "tools/hyrax/app.h"
#include "tools/hyrax/monitor.h"

namespace hyrax {

App::Monitor App::monitor_under(ScreenPoint point) {
  constexpr Desk kNoScreen{{0, 0}, {1024, 768}, {128, 128}};  // A window will not be made either.
  const HMONITOR handle = monitor_at(point);
  return {handle, desk_of(handle).value_or(kNoScreen)};
}

void App::settle_on(const Monitor& monitor) {
  home_ = monitor;
  pacer_.set_rate(refresh_hz(monitor.handle));
}

// Asked at every frame, too: when the system tells of another size, it still gives the old work area.
void App::look_at_screen() {
  if (playback_) return;
  if (const auto desk = desk_of(home_.handle)) {
    home_.desk = *desk;
  } else {
    const Size sprite = home_.desk.sprite;
    const ScreenPoint corner = pet_.place();
    settle_on(monitor_under({corner.x_px + sprite.width_px / 2, corner.y_px + sprite.height_px / 2}));
  }
  if (pet_.desk() == home_.desk) return;
  pet_.move_to(home_.desk, clock_ticks());
  is_frame_due_ = true;
}

// Time that the machine slept through is not the hyrax's.
void App::on_power(WPARAM change) {
  if (change == PBT_APMSUSPEND) {
    is_suspended_ = true;
    if (pet_.session().is_recording()) pet_.session().recording().save();
  }
  if (change != PBT_APMRESUMEAUTOMATIC) return;
  is_suspended_ = false;
  pet_.skip_time(clock_ticks());
  is_frame_due_ = true;
}

}  // namespace hyrax
