// The canonical text of a traced step (`hyrax-step/1`): equal texts are equal bits for every state, dt and
// size.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/trace/traced_step.h"

namespace hyrax {

/// The same step in one order: `a + b` and `a * b` in one order of their operands, signs moved out of
/// products and quotients, constants never negative, expressions that no path needs left out, expressions and
/// comparisons numbered by structure, outcomes of a path by their comparison, paths sorted.
[[nodiscard]] TracedStep in_order(const TracedStep& step);

/// The same step in canonical form: in order, and without comparisons that decide nothing: where two paths
/// differ in the outcome of one comparison alone, they are one path without it. However the step was
/// recorded, by whatever compiler, the form is the same.
[[nodiscard]] TracedStep canonical(const TracedStep& step);

/// The step's text, for files and reviews: a line an expression, comparison and path; numbers in shortest
/// round-trip and in hex. REQUIRES: in order.
[[nodiscard]] std::string step_text(const TracedStep& step);

/// The step of a text, canonical; nothing if it is not the text of a step in order: damaged, cut short,
/// edited by hand. The text may have comparisons that decide nothing, as earlier versions wrote them.
[[nodiscard]] std::optional<TracedStep> read_step(std::string_view text);

/// The same without writing it again to see whether it is the same text: for what this program wrote.
[[nodiscard]] std::optional<TracedStep> read_own_step(std::string_view text);

}  // namespace hyrax
