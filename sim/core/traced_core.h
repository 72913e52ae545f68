// The core of a traced step: what a replay plays without its header.
#pragma once

#include <optional>

#include "sim/core/core.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// Nothing if the step is not playable. REQUIRES: a step as canonical() or read_step() return it.
[[nodiscard]] std::optional<Core> traced_core(const TracedStep& step);

}  // namespace hyrax
