// The margin of a run in words.
#pragma once

#include <string>

#include "sim/reference/margin.h"

namespace hyrax {

/// Whether rounding alone may decide otherwise.
[[nodiscard]] bool is_knife_edge(const Margin& margin);

/// "any start within ±0.27 px and px/s keeps all contacts; nearest decision: right wall, step 135".
[[nodiscard]] std::string margin_text(const Margin& margin);

}  // namespace hyrax
