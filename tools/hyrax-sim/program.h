// The program hyrax-sim, for any core.
#pragma once

namespace hyrax {

struct Core;

/// What `main` returns, with its arguments.
/// @param is_own_program not hyrax-sim itself: suggested commands have the name by which it was called.
[[nodiscard]] int run_hyrax_sim(const Core& core, int argc, char** argv, bool is_own_program = false);

}  // namespace hyrax
