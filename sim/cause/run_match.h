// A core against a stored run: does its replay give the same rows, and each of its steps the state observed?
#pragma once

#include "sim/core/core.h"
#include "sim/motion/state.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/stored_run.h"

#include <cstdint>
#include <vector>

namespace hyrax {

/// What a golden file says its program played: its own frame times and inputs as a scenario. REQUIRES: rows.
[[nodiscard]] Scenario playback_of(const StoredRun& golden);

/// What of a replay is the stored run's, bit for bit.
struct RunMatch {
  bool rows = false;  ///< As many rows, each of the same dt, state and contact byte.
  bool times = false;
  bool contacts = false;
  [[nodiscard]] bool is_whole() const { return rows && times && contacts; }
};

/// Plays the scenario by the core with its parameters; no match if it does not take them. Ends at the first
/// block of rows that differs: times and contacts are then not compared to the end.
[[nodiscard]] RunMatch match(const Core& core, const Scenario& scenario, const StoredRun& run);

/// One step of a run: the state after the inputs of its frame, and what the core made of it.
struct ObservedStep {
  std::int64_t step = 0;       ///< Row number of `after`.
  bool follows_input = false;  ///< An input set position or velocity in its frame.
  World before;
  double dt_s = 0.0;
  State after;
};

/// The steps of a run: all of a short one; of a long one those of the first block
/// whose digest is not the one in `other`, and of the block before it. Held frames have none.
/// @param core plays the rows of a long run's blocks, from their keyframes. REQUIRES: as gives().
[[nodiscard]] std::vector<ObservedStep> observed_steps(const StoredRun& run, const StoredRun& other,
                                                       const Core& core);

/// Whether the core makes of the state the bits that were observed. REQUIRES: a core without members besides
/// x, y, vx and vy, since a row is all that is known of its state.
[[nodiscard]] bool gives(const Core& core, const ObservedStep& observed);

}  // namespace hyrax
