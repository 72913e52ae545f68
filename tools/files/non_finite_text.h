// What a run that became non-finite says of itself, wherever it is shown.
#pragma once

#include <string>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/row.h"

namespace hyrax {

/// "vx is NaN from step 23 of 200 (0.38 s)"; empty if the row is finite. A speed is named before the position
/// that it spoils.
/// @param last the last row of the run, which ends with its first row that is not finite.
[[nodiscard]] std::string non_finite_text(const Scenario& scenario, const Row& last);

}  // namespace hyrax
