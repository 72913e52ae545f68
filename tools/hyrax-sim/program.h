// The program hyrax-sim, for any core.
#pragma once

#include "sim/core/core.h"

namespace hyrax {

/// What `main` returns, with its arguments.
[[nodiscard]] int run_hyrax_sim(const Core& core, int argc, char** argv);

}  // namespace hyrax
