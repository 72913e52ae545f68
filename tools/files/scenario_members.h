// The members of a scenario document of the paper's core that have structure of their own: sizes, events,
// expect.
#pragma once

#include "sim/scenario/scenario.h"
#include "tools/files/event_reader.h"

namespace hyrax {

// Errors are added to the problems of the place; the values in question are then 0 or missing.
[[nodiscard]] Size read_window(const JsonPlace& here);
[[nodiscard]] Size read_sprite(const JsonPlace& here);
[[nodiscard]] Expect read_expect(const JsonPlace& here);

/// Reads `scenario.events`, and checks each event, their order and the frames that they are due at.
void read_events(const JsonPlace& here, const FramesRead& frames, Scenario& scenario);

}  // namespace hyrax
