// A scenario played before the eyes of a user, at the pace of its own clock.
#pragma once

#include <cstdint>
#include <string>

#include "sim/replay/replay.h"
#include "tools/files/failure.h"

namespace hyrax {

/// What a replay came to, for a program that ends with it.
struct Verdict {
  ExitCode exit_code = ExitCode::agreed;
  std::string sentence;
};

/// Whether the run has the state hash that its scenario carries; one that carries none agrees.
[[nodiscard]] Verdict verdict_on(const Scenario& scenario, const RunSummary& run);

/// The verdict on a scenario, played at once.
[[nodiscard]] Verdict replayed(const Scenario& scenario);

class Playback {
 public:
  /// Refers to the scenario. REQUIRES: as Replay; ticks_per_s > 0.
  Playback(const Scenario& scenario, std::int64_t ticks_per_s, std::int64_t ticks);

  /// Plays the frames whose time has come. Of a scenario whose frames are too short for that, so many at
  /// once that the program stays awake.
  void play(std::int64_t ticks);
  [[nodiscard]] bool is_over() const;
  [[nodiscard]] const Keyframe& now() const { return replay_.keyframe(); }
  /// The verdict; plays what is left.
  [[nodiscard]] Verdict finish();

 private:
  const Scenario& scenario_;
  std::int64_t ticks_per_s_;
  std::int64_t begin_ticks_;
  RowSink nobody_;
  Replay replay_;
  bool is_non_finite_ = false;
};

}  // namespace hyrax
