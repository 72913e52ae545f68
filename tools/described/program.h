// The program of a core that describes itself.
#pragma once

#include <atomic>

#include "sim/described/described_core.h"

namespace hyrax {

/// What `main` returns, with its arguments. @param make_core as built_described_core: the core may throw.
[[nodiscard]] int run_described_program(DescribedCore (*make_core)(), int argc, char** argv);

/// The core, of which a step, an action or a setter that changes rounding or flush-to-zero throws, which ends
/// the run at its row, and sets `has_changed`. The bits are then as they were. @param has_changed must
/// outlive the core.
[[nodiscard]] DescribedCore controlled(DescribedCore core, std::atomic<bool>& has_changed);

}  // namespace hyrax
