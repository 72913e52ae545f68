// The constants of the shipped core.
#pragma once

#include "sim/motion/state.h"

namespace hyrax {

/// The constants of class physics, read from it: few sources include the core itself.
[[nodiscard]] Constants core_constants();

}  // namespace hyrax
