// The canonical text of a traced step (`hyrax-step/1`): equal texts are equal bits for every state, dt and
// size.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/trace/traced_step.h"

namespace hyrax {

/// The same step in canonical form: `a + b` and `a * b` in one order of their operands, signs moved out of
/// products and quotients, constants never negative, expressions that no path needs left out, expressions and
/// comparisons numbered by structure, outcomes of a path by their comparison, paths sorted. However the step
/// was recorded, by whatever compiler, the form is the same.
[[nodiscard]] TracedStep canonical(const TracedStep& step);

/// The step's text, for files and reviews: a line an expression, comparison and path; numbers in shortest
/// round-trip and in hex. REQUIRES: canonical.
[[nodiscard]] std::string step_text(const TracedStep& step);

/// The step of a text; nothing if it is not the canonical text of a step: damaged, cut short, edited by hand.
[[nodiscard]] std::optional<TracedStep> read_step(std::string_view text);

}  // namespace hyrax
