// A core's replay against a stored run: does it give the same rows?
#pragma once

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// What a golden file says its program played: its own frame times and inputs as a scenario. The frame times
/// of a short run are those of its rows; those of a long one with a jittered clock are drawn again.
[[nodiscard]] Scenario playback_of(const StoredRun& golden);

/// What of a replay is the stored run's, bit for bit.
struct RunMatch {
  bool rows = false;  ///< As many rows, each of the same dt, state and contact byte.
  bool times = false;
  bool contacts = false;
  [[nodiscard]] bool is_whole() const { return rows && times && contacts; }
};

/// Plays the scenario by the core. Ends at the first block of rows that differs: times and contacts are then
/// not compared to the end.
[[nodiscard]] RunMatch match(const Core& core, const Scenario& scenario, const StoredRun& run);

}  // namespace hyrax
