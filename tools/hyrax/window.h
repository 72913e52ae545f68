// The window that shows the hyrax.
#pragma once

#include <exception>
#include <functional>

#include <windows.h>

#include "tools/hyrax/frame_log.h"
#include "tools/hyrax/pet.h"

namespace hyrax {

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

}  // namespace hyrax
