// What the user does with hand and menu.
#include "sim/scenario/split_mix64.h"
#include "tools/files/build_info.h"
#include "tools/hyrax/app.h"
#include "tools/hyrax/report.h"

namespace hyrax {
namespace {

ScreenPoint pointer_of_message() {
  // Where the pointer was when the message was sent; it may be elsewhere by now.
  const DWORD place = GetMessagePos();
  return {static_cast<std::int16_t>(LOWORD(place)), static_cast<std::int16_t>(HIWORD(place))};
}

bool is_button_down() {
  const bool is_left_handed = GetSystemMetrics(SM_SWAPBUTTON) != 0;
  return GetAsyncKeyState(is_left_handed ? VK_RBUTTON : VK_LBUTTON) < 0;
}

// Up and to a side, another way each time.
Velocity any_throw(std::uint64_t seed) {
  const double side = split_mix64_unit(seed, 0) < 0.5 ? -1.0 : 1.0;
  return {side * (600.0 + 1400.0 * split_mix64_unit(seed, 1)), -800.0 - 900.0 * split_mix64_unit(seed, 2)};
}

}  // namespace

// A menu or a message box keeps the message loop to itself; meanwhile a timer plays the frames. One may be
// opened inside another: the timer runs until the last one is closed.
class App::Modal {
 public:
  explicit Modal(App& app) : app_(app) {
    if (app_.modals_++ == 0) SetTimer(app_.window_, kModalTimer, USER_TIMER_MINIMUM, nullptr);
  }
  Modal(const Modal&) = delete;
  Modal& operator=(const Modal&) = delete;
  ~Modal() {
    if (--app_.modals_ == 0) KillTimer(app_.window_, kModalTimer);
  }

 private:
  App& app_;
};

void App::on_button_down() {
  if (playback_ || pet_.is_held()) return;
  SetCapture(window_);
  pet_.grab(pointer_of_message(), clock_ticks());
  is_frame_due_ = true;
}

void App::on_mouse_move() {
  if (!pet_.is_held()) return;
  const bool was_asleep = pet_.is_asleep();
  pet_.drag(pointer_of_message(), clock_ticks());
  if (was_asleep) is_frame_due_ = true;
}

void App::on_button_up() {
  if (pet_.is_held()) let_go(pointer_of_message());
}

// Asked at every frame of a hold: a window that is not in the foreground may be told nothing of a pointer
// that left it, and then a button that came up would never let go.
void App::follow_hand() {
  POINT pointer{};
  if (!pet_.is_held() || GetCursorPos(&pointer) == 0) return;
  const ScreenPoint hand{static_cast<std::int32_t>(pointer.x), static_cast<std::int32_t>(pointer.y)};
  is_button_down() ? pet_.drag(hand, clock_ticks()) : let_go(hand);
}

void App::let_go(ScreenPoint hand) {
  settle_on(monitor_under(hand));
  pet_.let_go(hand, clock_ticks(), home_.desk);
  ReleaseCapture();  // It is let go by now, so that the loss of capture means nothing.
  pacer_.arm();
}

void App::on_capture_lost(HWND taker) {
  if (taker == window_ || !pet_.is_held()) return;
  pet_.drop(clock_ticks());
  pacer_.arm();
}

void App::open_menu() {
  if (pet_.is_held()) return;
  Choice choice = Choice::none;
  {
    const Modal modal(*this);
    choice =
        choose_from_menu(window_, {playback_.has_value(), pet_.is_paused(), pet_.session().is_recording()});
  }
  try {
    obey(choice);
  } catch (const Failure& failure) {  // A file that cannot be written does not end the program.
    tell(failure.what());
  }
  is_frame_due_ = true;
}

void App::obey(Choice choice) {
  switch (choice) {
    case Choice::none:
      return;
    case Choice::throw_it:
      return throw_it();
    case Choice::pause:
      return toggle_pause();
    case Choice::reset:
      return pet_.reset(clock_ticks());
    case Choice::start_recording:
      return start_new_recording();
    case Choice::save_recording:
      return save_recording();
    case Choice::save_just_happened:
      return save_just_happened();
    case Choice::about:
      return tell_about();
    case Choice::quit:
      return static_cast<void>(DestroyWindow(window_));
  }
}

void App::throw_it() { pet_.fling(any_throw(static_cast<std::uint64_t>(clock_ticks())), clock_ticks()); }

void App::toggle_pause() {
  if (pet_.is_paused())
    pet_.resume(clock_ticks());
  else
    pet_.pause();
}

void App::tell_about() {
  const Modal modal(*this);
  const std::string text = "Hyrax " + std::string(build_info().version) +
                           "\n\nGrab it, drag it, let go.\n"
                           "What you record, hyrax-sim replays to the bit.";
  MessageBoxW(window_, to_wide(text).c_str(), L"About Hyrax", MB_OK | MB_ICONINFORMATION);
}

}  // namespace hyrax
