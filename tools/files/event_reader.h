// The `events` of a scenario document.
#pragma once

#include <optional>

#include "sim/scenario/scenario.h"
#include "tools/files/json_reader.h"

namespace hyrax {

/// Fills `scenario.events`, and tells what is wrong with each, with their order and with the frames they
/// fall on.
/// @param is_clock_good whether the clock was read; without it no `at_s` has a frame.
/// @param steps of the run, where they are known.
/// @param problems found so far.
void read_events(const JsonPlace& here, bool is_clock_good, std::optional<std::int64_t> steps,
                 Scenario& scenario, const JsonProblems& problems);

}  // namespace hyrax
