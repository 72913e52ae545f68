// What ladders of frame rates say: a table, a figure, sentences.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/rate_ladder.h"
#include "sim/result/result.h"

namespace hyrax {

/// Broken: faults of the runs. @param left_out further sentences. REQUIRES: a ladder; each has 60 and 240 Hz.
[[nodiscard]] Result ladder_result(const std::vector<RateLadder>& ladders,
                                   const std::vector<std::string>& left_out = {});

}  // namespace hyrax
