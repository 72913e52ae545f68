// All rows of a run, as often as they are asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/input.h"
#include "sim/trajectory/row_sink.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

/// A stretch at the end of a run in which the whole state comes again every `period_steps`.
struct Repetition {
  std::int64_t from_step = 0;
  std::int64_t period_steps = 0;
};

struct RunRows {
  Scenario scenario;
  std::vector<Input> inputs;
  std::int64_t steps = 0;  ///< The last row's number.
  double simulated_s = 0.0;
  std::optional<Repetition> repetition;  ///< As far as a replay noticed.
  std::string note;                      ///< What the reader must know of their origin; may be empty.

  /// Hands rows 0 .. last_step to the sink, in order. REQUIRES: last_step <= steps.
  std::function<void(RowSink& sink, std::int64_t last_step)> hand_to;
};

/// The rows of a replay, which was played once and came to `summary`.
[[nodiscard]] RunRows rows_of(const Scenario& scenario, const RunSummary& summary);

/// Whether the path is a trajectory file's, by its name or its first bytes.
[[nodiscard]] bool is_trajectory(const std::string& path);

/// The rows of a scenario or of a trajectory file; those of a file that does not hold every row are
/// replayed from the scenario in it.
/// ERRORS: Failure(cannot_access) and Failure(bad_input) of reading it.
[[nodiscard]] RunRows load_rows(const std::string& path);

}  // namespace hyrax
