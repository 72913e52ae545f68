// A traced step with other constants.
#pragma once

#include "sim/trace/traced_step.h"

namespace hyrax {

/// The step in which every constant of the value `from` is `to`: canonical. The step itself where it has
/// none. REQUIRES: canonical.
[[nodiscard]] TracedStep with_constant(const TracedStep& step, double from, double to);

}  // namespace hyrax
