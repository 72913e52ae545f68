// What `run` and `drift` share.
#pragma once

#include <cstdint>
#include <string>

#include "sim/core/core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// `replay` of a scenario, with progress on a terminal. The result does not depend on whether that is shown.
[[nodiscard]] RunSummary play_with_progress(const Core& core, const Scenario& scenario,
                                            std::vector<RowSink*> sinks, const ReplayOptions& options = {});

/// "first-fling: 600 steps, 10 s at 60 Hz".
[[nodiscard]] std::string title_of(const Scenario& scenario, std::int64_t steps, double simulated_s);

}  // namespace hyrax
