// The cores of a card: each compiled into a library of its own, and watched while it plays.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sim/core/core.h"

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

/// What a core's library gives (core_library.cpp). It hides all its other symbols, so that two headers that
/// both define `class physics`, and whatever else they define, never meet.
struct LibraryCore {
  Core counted;  ///< Counts every update (PlayWatch::updates).
  Core timed;    ///< As it is.
  /// The paper's constants that the header does not have, as "GRAVITY, AIR_DRAG"; empty: it has all.
  std::string lacking;
  /// Why results of this core cannot be compared, in a sentence without its full stop; empty: no such reason
  /// was found.
  std::string (*defect)() = nullptr;
};

/// The one symbol of a core's library. @param updates where it counts the updates that begin.
using CoreEntry = LibraryCore*(volatile std::int64_t* updates);
inline constexpr char kCoreEntry[] = "hyrax_library_core";

/// A core cannot be compared: why, a sentence without its full stop.
struct CoreRefused : std::runtime_error {
  CoreRefused(int number, const std::string& reason) : std::runtime_error(reason), core(number) {}
  int core;  ///< ComparedCore::number.
};

/// A core of the card. Where its header lacks one of the constants, its core has the paper's, from which
/// random runs and hard cases can be made; no run by it may be judged by them.
struct ComparedCore {
  int number = 0;  ///< Names the core where it is refused: 0 the base, 1 the candidate.
  PlayWatch* watch = nullptr;
  Core core;  ///< Each call ERRORS: CoreRefused, if the core throws or changes how the processor computes.
  Core timed;
  std::string lacking = {};  ///< As LibraryCore.

  /// The core, to play what is called so (PlayWatch::place).
  [[nodiscard]] const Core& at(const std::string& place) const {
    watch->core = number;
    watch->set_place(place);
    return core;
  }
};

/// @param record of its header. Refers to the record's texts and to the watch.
[[nodiscard]] ComparedCore compared_core(int number, const LibraryCore& library, const CoreRecord& record,
                                         PlayWatch& watch);

/// ERRORS: CoreRefused if rounding mode, subnormals or trapped exceptions are not as they were when the
/// program began. @param core number of the core that was called last.
void require_usual_arithmetic(int core, const std::string& where);

}  // namespace hyrax
