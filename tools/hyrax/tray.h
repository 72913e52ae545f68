// The icon in the notification area, and the menu of icon and hyrax.
#pragma once

#include <string>

#include <windows.h>

namespace hyrax {

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

enum class Choice {
  none = 0,
  throw_it = 1,
  pause = 2,
  reset = 3,
  start_recording = 4,
  save_recording = 5,
  save_just_happened = 6,
  about = 7,
  quit = 8,
};

struct MenuState {
  bool is_replay = false;  ///< A replay takes no inputs.
  bool is_paused = false;
  bool is_recording = false;
};

/// Shows the menu at the pointer until the user makes a choice or closes it.
[[nodiscard]] Choice choose_from_menu(HWND window, const MenuState& state);

/// Shows the version in a message box.
void show_about(HWND window);

}  // namespace hyrax
