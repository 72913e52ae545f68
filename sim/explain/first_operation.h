// The operation at which a step that nothing explains first differs.
#pragma once

#include <optional>

#include "sim/explain/observed_step.h"
#include "sim/motion/state.h"
#include "sim/motion/statement.h"

namespace hyrax {

/// The first operation of the listing whose result differs in this step, if the state after the step
/// determines it: vy shows gravity and drag together.
/// @param constants of the listing. REQUIRES: the listing does not give the step.
[[nodiscard]] std::optional<Operation> first_operation(const Constants& constants,
                                                       const ObservedStep& observed);

}  // namespace hyrax
