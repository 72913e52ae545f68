// An expression as a reader of the header would write it.
#pragma once

#include <map>
#include <string>

#include "sim/trace/traced_step.h"

namespace hyrax {

/// What is written for a number: the name that a header gives it.
using NumberNames = std::map<double, std::string>;

/// As "vx * AIR_DRAG + dt * 1250"; a long one shortened in the middle.
[[nodiscard]] std::string expression_text(const TracedStep& step, StepIndex expression,
                                          const NumberNames& names = {});

/// As "vx * AIR_DRAG > 9000".
[[nodiscard]] std::string comparison_text(const TracedStep& step, StepIndex comparison,
                                          const NumberNames& names = {});

}  // namespace hyrax
