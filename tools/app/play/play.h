// Plays a scenario for a command: with progress, or its rows as they are asked for.
#pragma once

#include <cstdint>
#include <string>

#include "sim/compare/equal_times.h"
#include "sim/core/core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// `replay` of a scenario, with progress on a terminal. The result does not depend on whether that is shown.
[[nodiscard]] RunSummary play_with_progress(const Core& core, const Scenario& scenario,
                                            std::vector<RowSink*> sinks, const ReplayOptions& options = {});

/// "first-fling: 600 steps, 10 s at 60 Hz".
[[nodiscard]] std::string title_of(const Scenario& scenario, std::int64_t steps, double simulated_s);

/// So many rows are played where no file holds them: a file of any origin may be of a far longer run.
inline constexpr std::int64_t kRowsPlayedMax = 20'000'000;

/// The first kRowsPlayedMax rows of a scenario's run.
[[nodiscard]] RowBatches played_rows(const Core& core, const Scenario& scenario);

}  // namespace hyrax
