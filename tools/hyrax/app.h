// The program: the hyrax in its window, the messages for it, and a frame whenever one is due.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <windows.h>

#include "tools/files/failure.h"
#include "tools/hyrax/frame_log.h"
#include "tools/hyrax/menu.h"
#include "tools/hyrax/options.h"
#include "tools/hyrax/pet.h"
#include "tools/hyrax/playback.h"
#include "tools/hyrax/window.h"

namespace hyrax {

class App {
 public:
  /// Opens the window. ERRORS: Failure: cannot_access if there is no screen, or a file cannot be used;
  /// bad_input for a scenario with errors.
  App(const Core& core, const PetOptions& options, HINSTANCE instance);
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Runs until the user, --seconds or the end of the replay ends it. ERRORS: Failure.
  [[nodiscard]] ExitCode run();

 private:
  LRESULT on_message(UINT message, WPARAM wide, LPARAM low);

  // Frames.
  void wait_for_work();
  void play_frame();
  void play_replayed_frame();
  void show(const Keyframe& now, Pose pose, bool faces_left);
  [[nodiscard]] bool is_asleep() const;
  [[nodiscard]] DWORD ms_to_end() const;

  // Screen and power.
  void check_monitors();
  void follow_monitor();
  void on_screen_change();
  void on_power(WPARAM change);

  // Hand and menu.
  void on_button_down();
  void on_mouse_move();
  void follow_hand();
  void let_go(ScreenPoint hand, std::int64_t ticks);
  void end_drag();
  void on_capture_lost(HWND taker);
  void open_menu();
  void execute(Choice choice);
  void notify(const std::string& sentence) const;

  FramePacer pacer_;
  Desk desk_;  // Whose rate the frames have.
  Pet pet_;
  ScenarioSaver saver_;
  Recorder recorder_;
  std::optional<FrameLog> log_;
  std::optional<Scenario> scenario_;  // The replayed one.
  std::optional<Playback> playback_;
  std::int64_t end_ticks_;
  Repeated monitor_checks_{clock_ticks_per_s(), 4};  // A check costs more than a frame.
  bool is_frame_due_ = true;
  bool is_suspended_ = false;  // The machine is about to sleep, or sleeps.
  bool has_ended_ = false;
  UINT taskbar_created_ = 0;
  std::unique_ptr<TrayIcon> tray_;
  Window window_;  // Last: closing it sends messages, which use the other members.
};

}  // namespace hyrax
