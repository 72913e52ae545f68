// What the system has: its clock, monitors and pointer, the window of the hyrax, the icon and the menu.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <windows.h>

#include "tools/hyrax/desk.h"
#include "tools/hyrax/frame_log.h"
#include "tools/hyrax/menu.h"
#include "tools/hyrax/pet.h"

namespace hyrax {

/// The performance counter, the clock of every frame.
[[nodiscard]] std::int64_t clock_ticks();
[[nodiscard]] std::int64_t clock_ticks_per_s();

/// A timer that is signalled once per frame.
class FramePacer {
 public:
  FramePacer();
  FramePacer(const FramePacer&) = delete;
  FramePacer& operator=(const FramePacer&) = delete;
  ~FramePacer();

  void set_rate(int hz) { period_ticks_ = clock_ticks_per_s() / hz; }
  [[nodiscard]] HANDLE handle() const { return timer_; }
  /// Sets the timer for the next frame.
  void arm();

 private:
  HANDLE timer_;
  std::int64_t period_ticks_;
  std::int64_t due_ticks_;
};

/// The work areas of all monitors, and the sizes of the sprite at their scalings.
[[nodiscard]] std::vector<Desk> all_desks();
/// That of the monitor at the point, or of the nearest one; without any, an arbitrary desk.
[[nodiscard]] Desk desk_under(ScreenPoint point);
/// Frames per second for the monitor at the point.
[[nodiscard]] int refresh_hz(ScreenPoint point);

/// The pointer when the current message was sent; it may have moved since.
[[nodiscard]] ScreenPoint pointer_of_message();
/// When that was, in ticks of the clock: earlier than now if the program stalled.
[[nodiscard]] std::int64_t ticks_of_message();
/// The pointer now. Nothing if the system refuses, as on a locked desktop.
[[nodiscard]] std::optional<ScreenPoint> pointer();
/// Whether the main button is pressed now.
[[nodiscard]] bool is_button_down();

/// What is drawn.
struct SpriteLook {
  Pose pose = Pose::fly;
  bool faces_left = false;
  Size size;
  bool operator==(const SpriteLook&) const = default;
};

/// A layered window, always on top, drawn with alpha from the PNG resources: the one of exactly the size of
/// the sprite, or a larger one scaled down.
class Window {
 public:
  /// Handles a message of the open window, as a window procedure.
  using Handler = std::function<LRESULT(UINT message, WPARAM wide, LPARAM low)>;
  static constexpr UINT_PTR kModalTimer = 1;

  /// Creates the window, still hidden. ERRORS: Failure(cannot_access).
  Window(HINSTANCE instance, Handler handler);
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  /// nullptr once it is closed.
  [[nodiscard]] HWND handle() const { return handle_; }
  /// Draws and moves the sprite if anything changed. ERRORS: Failure(program_fault).
  void show(const SpriteLook& look, ScreenPoint at);
  /// Where the window is, as the system reports it.
  [[nodiscard]] ScreenRect rect() const;
  void close() { DestroyWindow(handle_); }
  /// Throws what the handler threw since the last call, which cannot pass through the system.
  void rethrow_failure();

  /// A menu or a message box runs a message loop of its own. While at least one is open, a timer sends
  /// WM_TIMER with kModalTimer for each frame.
  class Modal {
   public:
    explicit Modal(Window& window);
    Modal(const Modal&) = delete;
    Modal& operator=(const Modal&) = delete;
    ~Modal();

   private:
    Window& window_;
  };

 private:
  static LRESULT CALLBACK window_procedure(HWND handle, UINT message, WPARAM wide, LPARAM low);
  void draw(const SpriteLook& look);

  ULONG_PTR gdiplus_ = 0;
  Handler handler_;
  HWND handle_ = nullptr;
  SpriteLook shown_;
  ScreenPoint shown_at_;
  int modals_ = 0;
  std::exception_ptr failure_;
};

class TrayIcon {
 public:
  /// @param message sent to the window when the icon is clicked.
  TrayIcon(HWND window, UINT message);
  TrayIcon(const TrayIcon&) = delete;
  TrayIcon& operator=(const TrayIcon&) = delete;
  ~TrayIcon();

  /// Adds the icon; needed again after the task bar was restarted.
  void show() const;
  /// Shows a notification beside it.
  void notify(const std::string& sentence) const;

 private:
  HWND window_;
  UINT message_;
};

/// Shows the menu at the pointer until the user makes a choice or closes it.
[[nodiscard]] Choice choose_from_menu(HWND window, const std::vector<MenuEntry>& entries);

/// A new file in "Documents\\Hyrax", named by the local time, as just-happened-20261121-134455.json.
[[nodiscard]] std::string new_recording_path(const std::string& name);

/// Shows the version in a message box, beside which the hyrax can be grabbed.
void show_about();

}  // namespace hyrax
