// The program hyrax-sim, for any core.
#pragma once

#include "sim/core/core.h"

namespace hyrax {

/// What `main` returns, with its arguments.
/// @param is_own_program not hyrax-sim itself: suggested commands have the name by which it was called.
[[nodiscard]] int run_hyrax_sim(const Core& core, int argc, char** argv, bool is_own_program = false);

}  // namespace hyrax
