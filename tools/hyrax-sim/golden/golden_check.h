// A scenario's run against its golden file.
#pragma once

#include <vector>

#include "sim/compare/comparison.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/run_summary.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// Plays the scenario against the kept run.
struct ComparedRun {
  Comparison comparison;
  RunSummary summary;
};
[[nodiscard]] ComparedRun compare_with(const StoredRun& kept, const Scenario& scenario);

/// Plays the scenario, rows wanted by nobody.
[[nodiscard]] RunSummary play(const Scenario& scenario);

/// Plays the scenario and keeps what a golden file holds. Memory does not grow with the contacts: of many,
/// the run passes them on in another replay.
struct FreshRun {
  StoredRun run;
  RunSummary summary;
};
[[nodiscard]] FreshRun play_for_golden(const Scenario& scenario);

}  // namespace hyrax
