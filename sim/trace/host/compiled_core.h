// The compiled core, held to the traced step.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/trace/host/core_calls.h"

namespace hyrax {
struct TracedStep;
}

namespace hyrax::trace {

using CompiledCore = CoreCalls<double, int>;

inline constexpr std::int64_t kCheckedSteps = 100'000;

/// Plays both from a grid of edges and from random states, the same on every machine.
/// @return the first step in which a bit differs, in words; nothing if none does. NaNs are alike.
[[nodiscard]] std::optional<std::string> step_that_differs(const CompiledCore& core, const TracedStep& step,
                                                           std::int64_t steps = kCheckedSteps);

/// The main program of a core's check: `PROGRAM STEP_FILE WHY_FILE` writes why the step is not complete, if
/// it is not.
int check_main(const CompiledCore& core, int argument_count, char** arguments);

}  // namespace hyrax::trace
