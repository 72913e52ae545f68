// The paper's step with any constants, as a core that a replay can play.
#pragma once

#include <memory>

#include "sim/replay/kernel.h"

namespace hyrax {

/// Plays the step of sim/motion/step.h, all parts in the paper's order. With the constants of class physics
/// it gives the bits of the shipped kernel, slower. A golden file's rows are restored with its own constants,
/// whatever this program's core does.
[[nodiscard]] std::unique_ptr<const Kernel> listing_kernel(const Constants& constants);

}  // namespace hyrax
