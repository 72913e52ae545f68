// An expression as a reader of the header would write it.
#pragma once

#include <cstdint>
#include <string>

#include "sim/trace/traced_step.h"

namespace hyrax {

/// As "vx * 0.999 + dt * 1250"; a long one shortened in the middle.
[[nodiscard]] std::string expression_text(const TracedStep& step, std::int32_t expression);

/// As "vx * 0.999 > 9000".
[[nodiscard]] std::string comparison_text(const TracedStep& step, std::int32_t comparison);

}  // namespace hyrax
