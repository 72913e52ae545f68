// A replay that shows how far it has come.
#pragma once

#include <cstdint>

#include "sim/replay/replay.h"

namespace hyrax {

/// Plays until row `end`, or until the state became non-finite, with progress on a terminal. The run is the
/// same with and without one, and so is the time it takes.
void play_shown(Replay& replay, std::int64_t end);

}  // namespace hyrax
