// The compiled core, held to the traced step.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/motion/state.h"
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

/// The main program of a core's check: `PROGRAM STEP_FILE WHY_FILE LISTING_FILE` writes why the step is not
/// complete, if it is not; else a LISTING_FILE, if the step is the paper's with these constants.
/// @param constants those of the paper's names; nothing: the core does not have them all.
int check_main(const CompiledCore& core, const std::optional<Constants>& constants, int argument_count,
               char** arguments);

}  // namespace hyrax::trace
