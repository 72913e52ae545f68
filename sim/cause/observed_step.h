// What a core made of a state, frame by frame.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/core.h"
#include "sim/motion/state.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

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
/// @param core plays the rows of a long run's blocks, from their keyframes. REQUIRES: as StepJudge.
[[nodiscard]] std::vector<ObservedStep> observed_steps(const StoredRun& run, const StoredRun& other,
                                                       const Core& core);

/// Takes single steps by a core, to compare them with what was observed. REQUIRES: a core without members
/// besides x, y, vx and vy, since a row is all that is known of its state.
class StepJudge {
 public:
  /// Refers to the core.
  explicit StepJudge(const Core& core) : core_(core) {}

  /// Whether the core makes of the state the bits that were observed.
  [[nodiscard]] bool gives(const ObservedStep& observed);

 private:
  const Core& core_;
  RowBlock rows_;
  StretchLog log_;
};

}  // namespace hyrax
