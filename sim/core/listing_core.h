// The paper's step with any constants, as a core that a replay can play.
#pragma once

#include "sim/core/core.h"

namespace hyrax {

/// Plays the step of sim/motion/step.h, all parts in the paper's order. With the constants of class physics
/// it gives the bits of the shipped core, slower. A golden file's rows are restored with its own constants,
/// whatever a program's core does.
[[nodiscard]] Core listing_core(const Constants& constants);

}  // namespace hyrax
