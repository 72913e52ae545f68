// A scenario of a core that describes itself at many frame rates.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/compare/rate_ladder.h"
#include "sim/described/described_comparison.h"

namespace hyrax {

/// Why a scenario cannot be played at other rates, as "an input has a value for each frame"; empty: it can.
[[nodiscard]] std::string why_one_rate(const DescribedScenario& scenario);

/// Plays it at each rate with even frames; events keep their times. At most 60 s, and less of many values.
/// @param faults_of a run: RateRun's. REQUIRES: has_px; why_one_rate is empty.
[[nodiscard]] RateLadder climb(
    const DescribedCore& core, const DescribedScenario& scenario, const std::vector<double>& rates_hz,
    const std::function<std::vector<std::string>(const DescribedSummary&)>& faults_of);

}  // namespace hyrax
