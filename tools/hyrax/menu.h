// The menu: its entries, and what each does to the hyrax and its recordings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/hyrax/recorder.h"

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
  bool is_replay = false;  ///< A replay takes no inputs.
  bool is_paused = false;
  bool is_recording = false;
};

struct MenuEntry {
  Choice choice = Choice::none;  ///< None: a separator.
  std::string text;              ///< An & precedes the letter that chooses it.
  bool is_enabled = true;
};

[[nodiscard]] std::vector<MenuEntry> menu_entries(const MenuState& state);

/// Does what was chosen; `about` and `quit` are the program's. ERRORS: Failure, as of the recorder.
void execute(Choice choice, Pet& pet, Recorder& recorder, std::int64_t ticks);

}  // namespace hyrax
