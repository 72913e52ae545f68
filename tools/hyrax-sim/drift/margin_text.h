// The margin of a run in words.
#pragma once

#include <string>

#include "sim/reference/margin.h"
#include "tools/hyrax-sim/golden/golden_check.h"

namespace hyrax {

/// Whether rounding alone may decide otherwise.
[[nodiscard]] bool is_knife_edge(const Margin& margin);

/// "any start within ±0.27 px and px/s keeps all contacts; nearest decision: right wall, step 135".
[[nodiscard]] std::string margin_text(const Margin& margin);

/// The margin of a fresh run as its summary says it: " (a knife edge)" is added where it is one.
[[nodiscard]] std::string margin_in_summary(const FreshRun& fresh);

}  // namespace hyrax
