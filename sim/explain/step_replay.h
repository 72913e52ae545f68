// Replays with a step as data in place of the core.
#pragma once

#include <string>

#include "sim/motion/statement.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// What a golden file says its program played: its own frame times and inputs as a scenario. The frame times
/// of a short run are those of its rows; those of a long one with a jittered clock are drawn again.
/// REQUIRES: `golden` outlives nothing of the result.
[[nodiscard]] Scenario playback_of(const StoredRun& golden);

/// Whether the scenario, played with this step, gives the run's rows: as many, of the same state hash. Ends
/// at the first block that differs.
/// @param observed the constants by which the replay detects which walls clamped: those of the run's
/// program.
[[nodiscard]] bool reproduces(const StepStatements& step, const Constants& observed, const Scenario& scenario,
                              const StoredRun& run);

}  // namespace hyrax
