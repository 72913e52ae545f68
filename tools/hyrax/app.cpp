#include "tools/hyrax/app.h"

#include <limits>

#include "tools/hyrax/arithmetic_pin.h"
#include "tools/hyrax/report.h"

namespace hyrax {
namespace {

constexpr UINT kTrayMessage = WM_APP + 1;
constexpr int kEscape = 1;  // The hot key during a drag.
constexpr UINT_PTR kMonitorTimer = Window::kModalTimer + 1;

std::int64_t end_of(const PetOptions& options) {
  if (!options.seconds) return std::numeric_limits<std::int64_t>::max();
  return clock_ticks() +
         static_cast<std::int64_t>(*options.seconds * static_cast<double>(clock_ticks_per_s()));
}

}  // namespace

App::App(const Core& core, const PetOptions& options, HINSTANCE instance)
    : desk_(desk_under({0, 0})),
      pet_(core, desk_, clock_ticks_per_s(), clock_ticks()),
      recorder_(pet_, saver_, clock_ticks_per_s(),
                {.notify = [this](const std::string& sentence) { notify(sentence); },
                 .new_path = new_recording_path}),
      scenario_(options.replay_path ? std::optional(load_for_pet(*options.replay_path)) : std::nullopt),
      end_ticks_(end_of(options)),
      window_(instance,
              [this](UINT message, WPARAM wide, LPARAM low) { return on_message(message, wide, low); }) {
  pacer_.set_rate(refresh_hz(desk_.origin));
  pet_.use_monitors(all_desks(), desk_, clock_ticks());
  if (options.record_path) recorder_.start(*options.record_path, clock_ticks());
  if (options.log_path) log_.emplace(*options.log_path);  // Last: it creates the file.
  if (scenario_) {
    playback_.emplace(core, *scenario_, clock_ticks_per_s(), clock_ticks());
    show(playback_->now(), Pose::fly, false);
  } else {
    pet_.skip_time(clock_ticks());
    show(pet_.session().now(), pet_.pose(), pet_.faces_left());
  }
  ShowWindow(window_.handle(), SW_SHOWNOACTIVATE);
  tray_ = std::make_unique<TrayIcon>(window_.handle(), kTrayMessage);
  taskbar_created_ = RegisterWindowMessageW(L"TaskbarCreated");
}

ExitCode App::run() {
  pacer_.arm();
  while (!has_ended_) {
    MSG message;
    while (!has_ended_ && PeekMessageW(&message, nullptr, 0, 0, PM_REMOVE) != 0) {
      has_ended_ = message.message == WM_QUIT;
      DispatchMessageW(&message);
      window_.rethrow_failure();
    }
    if (!has_ended_ && is_frame_due_) play_frame();
    if (clock_ticks() >= end_ticks_) has_ended_ = true;
    if (!has_ended_) wait_for_work();
  }
  recorder_.finish();
  if (log_) log_->finish();
  if (!playback_) return ExitCode::agreed;
  const PlaybackVerdict verdict = playback_->finish();
  report(verdict);
  return verdict.exit_code;
}

LRESULT App::on_message(UINT message, WPARAM wide, LPARAM low) {
  switch (message) {
    case WM_MOUSEACTIVATE:
      return MA_NOACTIVATE;  // Another window keeps the keyboard, and the drag continues.
    case WM_LBUTTONDOWN:
      on_button_down();
      return 0;
    case WM_MOUSEMOVE:
      on_mouse_move();
      return 0;
    case WM_LBUTTONUP:
      if (pet_.is_held()) let_go(pointer_of_message(), ticks_of_message());
      return 0;
    case WM_HOTKEY:
      if (pet_.is_held()) {
        pet_.cancel(clock_ticks());
        end_drag();
      }
      return 0;
    case WM_CAPTURECHANGED:
      on_capture_lost(reinterpret_cast<HWND>(low));
      return 0;
    case WM_RBUTTONUP:
      open_menu();
      return 0;
    case kTrayMessage:
      if (low == WM_RBUTTONUP || low == WM_LBUTTONUP) open_menu();
      return 0;
    case WM_TIMER:
      if (wide != kMonitorTimer) return play_frame(), 0;
      KillTimer(window_.handle(), kMonitorTimer);
      check_monitors();
      return 0;
    case WM_DISPLAYCHANGE:
    case WM_SETTINGCHANGE:
    case WM_DPICHANGED:
      on_screen_change();
      return 0;
    case WM_POWERBROADCAST:
      on_power(wide);
      return TRUE;
    case WM_ENDSESSION:
      if (wide != 0) recorder_.finish();
      return 0;
    case WM_DESTROY:
      tray_.reset();
      PostQuitMessage(0);
      return 0;
    default:
      if (message == taskbar_created_ && tray_) tray_->show();
      return DefWindowProcW(window_.handle(), message, wide, low);
  }
}

void App::wait_for_work() {
  const HANDLE timer = pacer_.handle();
  const DWORD handles = is_asleep() && !pet_.is_held() ? 0 : 1;
  const DWORD woken_by =
      MsgWaitForMultipleObjectsEx(handles, &timer, ms_to_end(), QS_ALLINPUT, MWMO_INPUTAVAILABLE);
  is_frame_due_ = handles == 1 && woken_by == WAIT_OBJECT_0;
}

bool App::is_asleep() const { return is_suspended_ || (!playback_ && pet_.is_asleep()); }

DWORD App::ms_to_end() const {
  if (end_ticks_ == std::numeric_limits<std::int64_t>::max()) return INFINITE;
  const std::int64_t left_ticks = end_ticks_ - clock_ticks();
  return left_ticks <= 0 ? 0 : static_cast<DWORD>(left_ticks * 1000 / clock_ticks_per_s() + 1);
}

void App::play_frame() {
  if (is_suspended_) return;
  pin_arithmetic();
  pacer_.arm();
  if (playback_) return play_replayed_frame();
  follow_hand();
  if (monitor_checks_.is_due(clock_ticks())) check_monitors();
  if (pet_.is_asleep()) return;
  pet_.frame(clock_ticks());
  follow_monitor();
  const Keyframe& now = pet_.session().now();
  show(now, pet_.pose(), pet_.faces_left());
  if (log_) log_->frame(now, desk_, pet_.inputs_of_frame(), window_.rect());
  if (pet_.is_asleep() && log_) log_->sleep(now);
  recorder_.save_if_due(clock_ticks());
}

void App::play_replayed_frame() {
  const std::int64_t shown_step = playback_->now().row.step;
  playback_->play(clock_ticks());
  const Keyframe& now = playback_->now();
  if (now.row.step > shown_step) {
    show(now, now.is_held ? Pose::held : Pose::fly, now.row.vx_px_per_s < 0.0);
    if (log_) log_->frame(now, desk_, {}, window_.rect());
  }
  if (playback_->is_over()) has_ended_ = true;
}

void App::show(const Keyframe& now, Pose pose, bool faces_left) {
  const Shown shown = shown_on(desk_, now.window, now.sprite, {now.row.x_px, now.row.y_px});
  window_.show({pose, faces_left, shown.sprite}, shown.at);
}

void App::check_monitors() {
  if (playback_) return;
  monitor_checks_.done(clock_ticks());
  pet_.use_monitors(all_desks(), desk_under(pet_.middle()), clock_ticks());
  if (pet_.desk() == desk_) return;
  follow_monitor();
  if (pet_.is_paused()) show(pet_.session().now(), pet_.pose(), pet_.faces_left());
  is_frame_due_ = true;
}

void App::follow_monitor() {
  if (pet_.desk() == desk_) return;
  desk_ = pet_.desk();
  pacer_.set_rate(refresh_hz(pet_.middle()));
}

// When the system reports another size, it may still return the old work area.
void App::on_screen_change() {
  constexpr UINT kLater_ms = 300;
  check_monitors();
  SetTimer(window_.handle(), kMonitorTimer, kLater_ms, nullptr);
}

// Time that the machine slept does not count.
void App::on_power(WPARAM change) {
  if (change == PBT_APMSUSPEND) {
    is_suspended_ = true;
    if (auto& recording = pet_.session().recording()) recording->save();
  }
  if (change != PBT_APMRESUMEAUTOMATIC) return;
  is_suspended_ = false;
  pet_.skip_time(clock_ticks());
  is_frame_due_ = true;
}

void App::on_button_down() {
  if (playback_ || pet_.is_held()) return;
  SetCapture(window_.handle());
  RegisterHotKey(window_.handle(), kEscape, 0, VK_ESCAPE);  // The keyboard is another window's.
  pet_.grab(pointer_of_message(), ticks_of_message());
  is_frame_due_ = true;
}

void App::on_mouse_move() {
  if (!pet_.is_held()) return;
  const bool was_asleep = pet_.is_asleep();
  pet_.drag(pointer_of_message(), ticks_of_message());
  if (was_asleep) is_frame_due_ = true;
}

// Polled at every frame of a drag: a window in the background may get no message when the pointer leaves it,
// and then would never get that of the released button.
void App::follow_hand() {
  if (!pet_.is_held()) return;
  const auto hand = pointer();
  if (!hand) return;
  is_button_down() ? pet_.drag(*hand, clock_ticks()) : let_go(*hand, clock_ticks());
}

void App::let_go(ScreenPoint hand, std::int64_t ticks) {
  pet_.let_go(hand, ticks, desk_under(hand));
  end_drag();
}

// It is no longer held, so that the message of the lost capture has no effect.
void App::end_drag() {
  ReleaseCapture();
  UnregisterHotKey(window_.handle(), kEscape);
  pacer_.arm();
}

void App::on_capture_lost(HWND taker) {
  if (taker == window_.handle() || !pet_.is_held()) return;
  pet_.drop(clock_ticks());
  end_drag();
}

void App::open_menu() {
  if (pet_.is_held()) return;
  Choice choice = Choice::none;
  {
    const Window::Modal modal(window_);
    choice =
        choose_from_menu(window_.handle(), menu_entries({.is_replay = playback_.has_value(),
                                                         .is_paused = pet_.is_paused(),
                                                         .is_recording = pet_.session().is_recording()}));
  }
  try {
    execute(choice);
  } catch (const Failure& failure) {  // A file that cannot be written does not end the program.
    notify(failure.what());
  }
  is_frame_due_ = true;
}

void App::execute(Choice choice) {
  if (choice == Choice::quit) return window_.close();
  if (choice != Choice::about) return hyrax::execute(choice, pet_, recorder_, clock_ticks());
  const Window::Modal modal(window_);
  show_about();
}

// The icon is gone if the window was closed while a message box is open.
void App::notify(const std::string& sentence) const {
  if (tray_) tray_->notify(sentence);
}

}  // namespace hyrax
