// Smaller scenarios made from one: fewer frames, fewer events, a later start.
//
// All take and give plain scenarios: events have frame numbers, the length is a number of frames (of a
// recorded clock its own), nothing is expected.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// The same run as a plain scenario. REQUIRES: the events of the scenario have frames.
[[nodiscard]] Scenario plain(const Scenario& scenario);

/// Without frames first .. last - 1 and their events. REQUIRES: 0 <= first <= last <= step_count(scenario).
[[nodiscard]] Scenario without_frames(const Scenario& scenario, std::int64_t first, std::int64_t last);

/// Without events first .. last - 1. REQUIRES: first <= last <= scenario.events.size().
[[nodiscard]] Scenario without_events(const Scenario& scenario, std::size_t first, std::size_t last);

/// What comes after the first `frames` frames, from the state that the replay has there: a jittered clock
/// draws again from its first number. REQUIRES: 0 <= frames <= step_count(scenario).
[[nodiscard]] Scenario after_frames(const Scenario& scenario, std::int64_t frames);

/// Every frame's dt recorded, its hitch too. REQUIRES: step_count(scenario) > 0.
[[nodiscard]] Scenario recorded(const Scenario& scenario);

/// Whether a plain scenario is within the limits of the format: its numbers, the order of its events, and
/// grab and release in turn.
[[nodiscard]] bool is_valid(const Scenario& scenario);

}  // namespace hyrax
