// A core that describes itself, of which the step is data.
#pragma once

#include "sim/described/described_core.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// The lists whose values are the members of a step, in this order; contacts follow them.
inline constexpr SettableList kStepLists[] = {SettableList::parameters, SettableList::inputs,
                                              SettableList::state};

/// The core with this step, which is interpreted, without outputs and properties. REQUIRES: a complete step
/// with the members and functions of the core's own.
[[nodiscard]] DescribedCore interpreted(const DescribedCore& core, TracedStep step);

}  // namespace hyrax
