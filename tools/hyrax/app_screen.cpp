// What the program does when the screen changes, another monitor becomes the hyrax's, or the machine sleeps.
#include "tools/hyrax/app.h"
#include "tools/hyrax/monitor.h"

namespace hyrax {
namespace {

// To ask costs more than a frame.
constexpr std::int64_t kLooksPerSecond = 4;

}  // namespace

App::Monitor App::monitor_under(ScreenPoint point) {
  constexpr Desk kNoScreen{{0, 0}, {1024, 768}, {128, 128}};  // A window will not be made either.
  const HMONITOR handle = monitor_at(point);
  return {handle, desk_of(handle).value_or(kNoScreen)};
}

void App::settle_on(const Monitor& monitor) {
  home_ = monitor;
  pacer_.set_rate(refresh_hz(monitor.handle));
}

void App::look_at_screen() {
  if (playback_) return;
  next_look_ticks_ = clock_ticks() + clock_ticks_per_s() / kLooksPerSecond;
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

// When the system tells of another size, it may still give the old work area.
void App::on_screen_change() {
  constexpr UINT kLater_ms = 300;
  look_at_screen();
  SetTimer(window_, kLookTimer, kLater_ms, nullptr);
}

void App::look_again_at_screen() {
  KillTimer(window_, kLookTimer);
  look_at_screen();
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
