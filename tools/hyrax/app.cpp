#include "tools/hyrax/app.h"

#include <limits>

#include "tools/files/atomic_file.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax/arithmetic_pin.h"
#include "tools/hyrax/monitor.h"
#include "tools/hyrax/report.h"
#include "tools/hyrax/resource_ids.h"

namespace hyrax {
namespace {

constexpr wchar_t kClass[] = L"hyrax";
constexpr wchar_t kTitle[] = L"Hyrax";
constexpr UINT kTrayMessage = WM_APP + 1;

std::int64_t end_of(const Options& options) {
  if (!options.seconds) return std::numeric_limits<std::int64_t>::max();
  return clock_ticks() +
         static_cast<std::int64_t>(*options.seconds * static_cast<double>(clock_ticks_per_s()));
}

HWND make_window(HINSTANCE instance, WNDPROC take_message, void* app) {
  WNDCLASSEXW kind{};
  kind.cbSize = sizeof kind;
  kind.lpfnWndProc = take_message;
  kind.hInstance = instance;
  kind.hIcon = LoadIconW(instance, MAKEINTRESOURCEW(HYRAX_ICON));
  kind.hCursor = LoadCursorW(nullptr, IDC_HAND);
  kind.lpszClassName = kClass;
  RegisterClassExW(&kind);
  const HWND window = CreateWindowExW(WS_EX_LAYERED | WS_EX_TOPMOST | WS_EX_TOOLWINDOW | WS_EX_NOACTIVATE,
                                      kClass, kTitle, WS_POPUP, 0, 0, 1, 1, nullptr, nullptr, instance, app);
  if (window == nullptr)
    throw Failure(ExitCode::cannot_access, "hyrax: no window can be made (error " +
                                               std::to_string(GetLastError()) +
                                               "); it needs a screen, as of a user who is logged in");
  return window;
}

}  // namespace

App::App(const Options& options, HINSTANCE instance)
    : home_(monitor_under({0, 0})),
      pet_(home_.desk, clock_ticks_per_s(), clock_ticks()),
      end_ticks_(end_of(options)) {
  if (options.log_path) log_.emplace(*options.log_path);
  if (options.replay_path) scenario_ = load_scenario(*options.replay_path);
  window_ = make_window(instance, &App::take_message, this);
  settle_on(home_);
  if (options.record_path) start_recording(*options.record_path);
  if (scenario_) {
    playback_.emplace(*scenario_, clock_ticks_per_s(), clock_ticks());
    show(playback_->now(), Pose::fly, false);
  } else {
    pet_.skip_time(clock_ticks());
    show(pet_.session().now(), pet_.pose(), pet_.faces_left());
  }
  ShowWindow(window_, SW_SHOWNOACTIVATE);
  tray_ = std::make_unique<TrayIcon>(window_, kTrayMessage);
  taskbar_created_ = RegisterWindowMessageW(L"TaskbarCreated");
}

App::~App() {
  tray_.reset();
  if (window_ != nullptr) DestroyWindow(window_);
}

ExitCode App::run() {
  pacer_.arm();
  while (!exit_code_) {
    MSG message;
    while (!exit_code_ && PeekMessageW(&message, nullptr, 0, 0, PM_REMOVE) != 0) {
      if (message.message == WM_QUIT) exit_code_ = ExitCode::agreed;
      DispatchMessageW(&message);
      if (fault_) std::rethrow_exception(fault_);
    }
    if (!exit_code_ && is_frame_due_) play_frame();
    if (clock_ticks() >= end_ticks_) exit_code_ = exit_code_.value_or(ExitCode::agreed);
    if (!exit_code_) wait_for_work();
  }
  finish_recording();
  return *exit_code_;
}

LRESULT CALLBACK App::take_message(HWND window, UINT message, WPARAM wide, LPARAM low) {
  if (message == WM_NCCREATE)
    SetWindowLongPtrW(window, GWLP_USERDATA,
                      reinterpret_cast<LONG_PTR>(reinterpret_cast<CREATESTRUCTW*>(low)->lpCreateParams));
  auto* const app = reinterpret_cast<App*>(GetWindowLongPtrW(window, GWLP_USERDATA));
  // Messages that come while the window is made or gone concern nobody.
  if (app == nullptr || app->window_ == nullptr) return DefWindowProcW(window, message, wide, low);
  try {
    return app->on_message(message, wide, low);
  } catch (...) {
    app->fault_ = std::current_exception();
    PostMessageW(window, WM_NULL, 0, 0);
    return 0;
  }
}

LRESULT App::on_message(UINT message, WPARAM wide, LPARAM low) {
  switch (message) {
    case WM_MOUSEACTIVATE:
      return MA_NOACTIVATE;  // The window that the user types into keeps the keyboard, and the drag goes on.
    case WM_LBUTTONDOWN:
      on_button_down();
      return 0;
    case WM_MOUSEMOVE:
      on_mouse_move();
      return 0;
    case WM_LBUTTONUP:
      on_button_up();
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
      wide == kLookTimer ? look_again_at_screen() : play_frame();
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
      if (wide != 0) finish_recording();
      return 0;
    case WM_DESTROY:
      tray_.reset();
      window_ = nullptr;
      PostQuitMessage(0);
      return 0;
    default:
      if (message == taskbar_created_ && tray_) tray_->show();
      return DefWindowProcW(window_, message, wide, low);
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
  if (playback_) return play_replayed_frame();
  pacer_.arm();
  follow_hand();
  if (clock_ticks() >= next_look_ticks_) look_at_screen();
  if (pet_.is_asleep()) return;
  pet_.frame(clock_ticks());
  const Keyframe& now = pet_.session().now();
  show(now, pet_.pose(), pet_.faces_left());
  log(now, pet_.inputs_of_frame());
  if (pet_.is_asleep() && log_) log_->sleep(now);
  save_if_due();
}

void App::play_replayed_frame() {
  pacer_.arm();
  playback_->play(clock_ticks());
  const Keyframe& now = playback_->now();
  show(now, now.is_held ? Pose::held : Pose::fly, now.row.vx_px_per_s < 0.0);
  log(now, {});
  if (!playback_->is_over()) return;
  const Verdict verdict = playback_->finish();
  say(verdict);
  exit_code_ = verdict.exit_code;
}

void App::show(const Keyframe& now, Pose pose, bool faces_left) {
  sprite_.show(window_, {pose, faces_left, now.sprite});
  const ScreenPoint at = on_screen(home_.desk, {now.row.x_px, now.row.y_px});
  if (at == shown_at_) return;
  shown_at_ = at;
  SetWindowPos(window_, nullptr, at.x_px, at.y_px, 0, 0,
               SWP_NOSIZE | SWP_NOZORDER | SWP_NOACTIVATE | SWP_NOOWNERZORDER);
}

void App::log(const Keyframe& now, const std::vector<Action>& inputs) {
  if (!log_) return;
  RECT rect{};
  GetWindowRect(window_, &rect);
  log_->frame(now, home_.desk, inputs,
              {static_cast<std::int32_t>(rect.left), static_cast<std::int32_t>(rect.top),
               static_cast<std::int32_t>(rect.right), static_cast<std::int32_t>(rect.bottom)});
}

}  // namespace hyrax
