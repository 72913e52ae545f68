// A fling of a core of the paper's interface at many frame rates.
#pragma once

#include <vector>

#include "sim/compare/rate_ladder.h"
#include "sim/core/core.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// Plays it at each rate with even frames. REQUIRES: a length in s; no events.
[[nodiscard]] RateLadder climb(const Core& core, const Scenario& fling, const std::vector<double>& rates_hz);

}  // namespace hyrax
