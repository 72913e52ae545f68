// The menu of the hyrax and of its icon.
#pragma once

#include <windows.h>

namespace hyrax {

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
  bool is_replay = false;  ///< Nothing can be done to a hyrax that only repeats itself.
  bool is_paused = false;
  bool is_recording = false;
};

/// Shows the menu at the pointer and returns when something, or nothing, was chosen.
[[nodiscard]] Choice choose_from_menu(HWND window, const MenuState& state);

}  // namespace hyrax
