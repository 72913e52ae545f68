// What `run` and `drift` share.
#pragma once

#include <cstdint>
#include <string>

#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// Plays until row `end`, or until the state became non-finite, with progress on a terminal. The result does
/// not depend on whether progress is shown.
void play_with_progress(Replay& replay, std::int64_t end);

/// "first-fling: 600 steps, 10 s at 60 Hz".
[[nodiscard]] std::string title_of(const Scenario& scenario, std::int64_t steps, double simulated_s);

}  // namespace hyrax
