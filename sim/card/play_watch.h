// What a core is doing, in memory that another process can read after a core has ended its own.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace hyrax {

/// All of it 0 at first.
struct PlayWatch {
  int core;                       ///< ComparedCore::number of the core that plays.
  std::array<char, 160> place;    ///< What is played, "scenario hard/corner.json"; ends with a 0.
  std::int64_t from_step;         ///< Row before the call that plays it,
  std::int64_t steps;             ///< and how many it plays; 0 where its updates are not those of a run.
  volatile std::int64_t updates;  ///< Begun by the call; written by the core's library before each.
  bool is_over;                   ///< The process has done its work: how it ends is its own doing.

  /// Cut where it does not fit.
  void set_place(std::string_view text) {
    place[text.copy(place.data(), place.size() - 1)] = '\0';
    begin_call(0, 0);
  }
  void begin_call(std::int64_t after_step, std::int64_t steps_to_play) {
    from_step = after_step;
    steps = steps_to_play;
    updates = 0;
  }
  /// "scenario hard/corner.json, step 57".
  [[nodiscard]] std::string where() const {
    const std::string text = place.data();
    const std::int64_t begun = updates;
    return begun == 0 || begun > steps ? text : text + ", step " + std::to_string(from_step + begun);
  }
};

}  // namespace hyrax
