// Replays a scenario in the time of its own clock, to be watched.
#pragma once

#include <cstdint>
#include <string>

#include "sim/core/core.h"
#include "sim/replay/replay.h"
#include "tools/files/failure.h"

namespace hyrax {

/// The result of a replay, with which the program ends.
struct PlaybackVerdict {
  ExitCode exit_code = ExitCode::agreed;
  std::string sentence;
};

/// A scenario to be played by the pet. ERRORS: as load_scenario's; Failure(bad_input) for one of other
/// constants than the pet's.
[[nodiscard]] Scenario load_for_pet(const std::string& path);

/// Plays a scenario at once: whether it has the state hash that it expects; without one it agrees.
[[nodiscard]] PlaybackVerdict replayed(const Core& core, const Scenario& scenario);

class Playback {
 public:
  /// Refers to the scenario. REQUIRES: as Replay; ticks_per_s > 0.
  Playback(const Core& core, const Scenario& scenario, std::int64_t ticks_per_s, std::int64_t ticks);

  /// Plays the frames that are due, at most so many at once that the program stays responsive.
  void play(std::int64_t ticks);
  [[nodiscard]] bool is_over() const;
  [[nodiscard]] const Keyframe& now() const { return replay_.keyframe(); }
  /// The verdict. Before is_over, the hash that is expected was not compared: disagreed.
  [[nodiscard]] PlaybackVerdict finish();

 private:
  const Scenario& scenario_;
  std::int64_t ticks_per_s_;
  std::int64_t begin_ticks_;
  Replay replay_;
  bool is_non_finite_ = false;
};

}  // namespace hyrax
