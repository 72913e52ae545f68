// All rows of a run, as often as they are needed.
#pragma once

#include <cassert>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/row_sink.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

/// The end of a run, in which the whole state repeats every `period_steps`.
struct Repetition {
  std::int64_t from_step = 0;
  std::int64_t period_steps = 0;
};

struct RunRows {
  Scenario scenario;
  std::vector<Input> inputs;
  std::int64_t steps = 0;  ///< The last row's number.
  double simulated_s = 0.0;
  std::optional<Repetition> repetition;  ///< If a replay detected one.
  std::string note;                      ///< What the reader should know about their origin; may be empty.
  std::function<void(RowSink& sink, std::int64_t last_step)> source;

  /// Sends rows 0 .. last_step to the sink, in order. REQUIRES: last_step <= steps.
  void send_to(RowSink& sink, std::int64_t last_step) const {
    assert(last_step <= steps);
    source(sink, last_step);
  }
};

/// The rows of a replay that was played once, with that summary.
[[nodiscard]] RunRows rows_of(const Scenario& scenario, const RunSummary& summary);

/// Whether the path is a trajectory file's, by its name or its first bytes.
[[nodiscard]] bool is_trajectory(const std::string& path);

/// The rows of a trajectory file; if it does not hold every row, they are replayed from the scenario in it.
/// ERRORS: Failure(cannot_access), Failure(bad_input) as TrajectoryFile::open's.
[[nodiscard]] RunRows load_rows(const std::string& path);

/// Plays until row `end`, or until the state became non-finite, with progress on a terminal. The result does
/// not depend on whether progress is shown.
void play_with_progress(Replay& replay, std::int64_t end);

/// "first-fling: 600 steps, 10 s at 60 Hz".
[[nodiscard]] std::string title_of(const Scenario& scenario, std::int64_t steps, double simulated_s);

}  // namespace hyrax
