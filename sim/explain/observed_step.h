// What a core made of a state, frame by frame: the evidence on which candidates are tried first.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/motion/state.h"
#include "sim/motion/statement.h"
#include "sim/replay/kernel.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// One step of a run: the state after the inputs of its frame, and what the core made of it.
struct ObservedStep {
  std::int64_t step = 0;       ///< Row number of `after`.
  bool follows_input = false;  ///< An input set position or velocity in its frame.
  State before;
  double dt_s = 0.0;
  Bounds bounds;
  State after;
};

/// The steps of a run: all of a short one; of a long one those of the first block
/// whose digest is not the one in `golden`, and of the block before it. Held frames have none.
/// @param program the core that played it.
[[nodiscard]] std::vector<ObservedStep> observed_steps(const StoredRun& run, const StoredRun& golden,
                                                       const Kernel& program);

/// Whether the step makes of the state the bits that were observed.
[[nodiscard]] bool gives(const StepStatements& step, const ObservedStep& observed);

}  // namespace hyrax
