// The rows of a run, played as they are asked for.
#pragma once

#include <cstdint>

#include "sim/compare/equal_times.h"
#include "sim/core/core.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// So many rows are played where no file holds them: a file of any origin may be of a far longer run.
inline constexpr std::int64_t kRowsPlayedMax = 20'000'000;

/// The first kRowsPlayedMax rows of a scenario's run.
[[nodiscard]] RowBatches played_rows(const Core& core, const Scenario& scenario);

}  // namespace hyrax
