// The program: one window, its messages, and a frame whenever one is due.
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>

#include <windows.h>

#include "tools/files/failure.h"
#include "tools/hyrax/frame_log.h"
#include "tools/hyrax/frame_pacer.h"
#include "tools/hyrax/menu.h"
#include "tools/hyrax/options.h"
#include "tools/hyrax/pet.h"
#include "tools/hyrax/playback.h"
#include "tools/hyrax/scenario_saver.h"
#include "tools/hyrax/sprite.h"
#include "tools/hyrax/tray_icon.h"

namespace hyrax {

class App {
 public:
  /// Makes the window. ERRORS: Failure: cannot_access where there is no screen, or a file cannot be used;
  /// bad_input for a scenario that is wrong.
  App(const Options& options, HINSTANCE instance);
  App(const App&) = delete;
  App& operator=(const App&) = delete;
  ~App();

  /// Runs until the user, --seconds or the end of the replay ends it. ERRORS: Failure.
  [[nodiscard]] ExitCode run();

 private:
  struct Monitor {
    HMONITOR handle;
    Desk desk;
  };

  // Timers of the window: one plays frames while a menu or a message has the message loop to itself, one
  // looks at the screen once more.
  static constexpr UINT_PTR kModalTimer = 1;
  static constexpr UINT_PTR kLookTimer = 2;

  class Modal;

  static LRESULT CALLBACK take_message(HWND window, UINT message, WPARAM wide, LPARAM low);
  LRESULT on_message(UINT message, WPARAM wide, LPARAM low);

  // Time.
  void wait_for_work();
  void play_frame();
  void play_replayed_frame();
  void show(const Keyframe& now, Pose pose, bool faces_left);
  void log(const Keyframe& now, const std::vector<Action>& inputs);
  [[nodiscard]] bool is_asleep() const;
  [[nodiscard]] DWORD ms_to_end() const;

  void on_power(WPARAM change);

  // Screen.
  [[nodiscard]] static Monitor monitor_under(ScreenPoint point);
  void settle_on(const Monitor& monitor);
  void look_at_screen();
  void on_screen_change();
  void look_again_at_screen();

  // Hand and menu.
  void on_button_down();
  void on_mouse_move();
  void on_button_up();
  void follow_hand();
  void let_go(ScreenPoint hand);
  void on_capture_lost(HWND taker);
  void open_menu();
  void obey(Choice choice);
  void throw_it();
  void toggle_pause();
  void tell_about();

  // Recording.
  void start_recording(const std::string& path);
  void start_new_recording();
  void finish_recording();
  void save_recording();
  void save_just_happened();
  void continue_recording();
  void save_if_due();
  void tell(const std::string& sentence) const;

  Gdiplus gdiplus_;
  FramePacer pacer_;
  ScenarioSaver saver_;
  std::optional<FrameLog> log_;
  std::optional<Scenario> scenario_;  // That is replayed.
  std::optional<Playback> playback_;
  HWND window_ = nullptr;
  UINT taskbar_created_ = 0;
  Monitor home_;
  Pet pet_;
  Sprite sprite_;
  ScreenPoint shown_at_;
  std::unique_ptr<TrayIcon> tray_;
  std::int64_t end_ticks_;
  std::int64_t next_save_ticks_ = 0;
  std::int64_t next_look_ticks_ = 0;
  std::string told_;  // Of what could not be written, last.
  int modals_ = 0;    // Menus and message boxes that are open, one inside the other.
  bool is_frame_due_ = true;
  bool is_suspended_ = false;  // The machine is about to sleep, or sleeps.
  std::optional<ExitCode> exit_code_;
  std::exception_ptr fault_;  // Of a message, which may not be thrown through the system.
};

}  // namespace hyrax
