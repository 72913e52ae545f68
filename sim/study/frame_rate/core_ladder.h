// A scenario of a core of the paper's interface at many frame rates.
#pragma once

#include <vector>

#include "sim/compare/rate_ladder.h"
#include "sim/core/core.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// Plays it at each rate with even frames; events keep their times. At most 60 s. REQUIRES: of the scenario
/// the parameters are the core's.
[[nodiscard]] RateLadder climb(const Core& core, const Scenario& scenario,
                               const std::vector<double>& rates_hz);

}  // namespace hyrax
