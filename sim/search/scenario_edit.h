// Smaller scenarios made from one: fewer frames, fewer events, a later start.
//
// All take and give plain scenarios: events have frame numbers, the length is a number of frames (of a
// recorded clock its own), nothing is expected.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/core/core.h"
#include "sim/scenario/numbers.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// The same run as a plain scenario. REQUIRES: the events of the scenario have frames.
[[nodiscard]] Scenario plain(const Scenario& scenario);

/// Without frames first .. last - 1 and their events. REQUIRES: 0 <= first <= last <= step_count(scenario).
[[nodiscard]] Scenario without_frames(const Scenario& scenario, std::int64_t first, std::int64_t last);

/// Without events first .. last - 1. REQUIRES: first <= last <= scenario.events.size().
[[nodiscard]] Scenario without_events(const Scenario& scenario, std::size_t first, std::size_t last);

/// What comes after the first `frames` frames, from the state that the core has there: a jittered clock
/// draws again from its first number. REQUIRES: 0 <= frames <= step_count(scenario).
[[nodiscard]] Scenario after_frames(const Core& core, const Scenario& scenario, std::int64_t frames);

/// Every frame's dt recorded, its hitch too. REQUIRES: step_count(scenario) > 0.
[[nodiscard]] Scenario recorded(const Scenario& scenario);

/// Whether a plain scenario is within the limits of the format: its numbers, the order of its events, and
/// grab and release in turn.
[[nodiscard]] bool is_valid(const Scenario& scenario);

/// Significant decimal digits of the shortest text of each number, in sum: 0 has none, 1e9 one.
[[nodiscard]] std::int64_t digits_of(const Scenario& scenario);

/// The longest a number can be.
inline constexpr int kDigitsMax = 17;

/// Rounds the number to so many significant decimal digits; 0 digits: to 0. A size or a seed is cut to its
/// leading digits.
void round_to(const NumberField& number, int digits);

}  // namespace hyrax
