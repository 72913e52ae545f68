// The kernel of a traced step: what a replay plays without its header.
#pragma once

#include <memory>

#include "sim/replay/kernel.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// Null if the step is not playable, or has members that a row does not: between two stretches they would be
/// lost. REQUIRES: a step as canonical() or read_step() return it.
[[nodiscard]] std::unique_ptr<const Kernel> make_traced_kernel(const TracedStep& step);

}  // namespace hyrax
