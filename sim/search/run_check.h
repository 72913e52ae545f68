// One run held to the invariants that every run must keep.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/search/invariant.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

struct CheckedRun {
  RunSummary summary;
  InvariantMeasures measures{};
  double last_speed_px_per_s = 0.0;  ///< See StepWatch.
  std::int64_t knife_edges = 0;      ///< See StepWatch.
};

/// Rows at which a run is stopped if nothing else is asked for: at the first input past the start, or a
/// third, and at two thirds.
[[nodiscard]] std::vector<std::int64_t> usual_stops(const Scenario& scenario);

/// Plays the scenario with every step checked, then with repetition skipped, then stopped and resumed.
/// @param stops rows 0 .. steps in order: the last run is stopped at each, and resumed from its keyframe.
/// @param report_steps called with the number of steps checked, during the first run, the longest.
/// REQUIRES: as Replay.
[[nodiscard]] CheckedRun check_run(const Core& core, const Scenario& scenario,
                                   std::span<const std::int64_t> stops,
                                   const std::function<void(std::int64_t)>& report_steps = {});

/// Whether the paper's listing itself breaks the invariant in scenarios like this one: it applies drag in a
/// zero-length frame, and of two side walls that both claim a sprite wider than its window the left one wins.
[[nodiscard]] bool is_broken_by_listing(Invariant invariant, const Scenario& scenario);

/// The invariants that do not hold though the listing keeps them.
[[nodiscard]] std::vector<Invariant> broken_invariants(const Scenario& scenario,
                                                       const InvariantMeasures& measures);

}  // namespace hyrax
