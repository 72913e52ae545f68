// How a run depends on its start: the margin, and how far its end moves.
#pragma once

#include <string>

#include "sim/reference/margin.h"
#include "sim/result/table.h"

namespace hyrax {

/// Whether rounding alone can change a contact.
[[nodiscard]] bool is_knife_edge(const Margin& margin);

/// "any start within ±0.27 px and px/s keeps all contacts; nearest decision: right wall, step 135".
[[nodiscard]] std::string margin_text(const Margin& margin);

/// The line of the text. @param all the table of d(end) / d(start), too.
[[nodiscard]] std::string start_text(const Margin& margin, bool all);

/// d(end) / d(start) as rows of numbers.
[[nodiscard]] Table sensitivity_table(const Sensitivity& sensitivity);
/// The member "margin" of a document.
[[nodiscard]] Table margin_table(const Margin& margin);

}  // namespace hyrax
