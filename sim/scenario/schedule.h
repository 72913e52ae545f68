// Which frame each event of a scenario falls on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// Why an event has no frame.
enum class ScheduleFault { beyond_end, goes_backwards };

struct Schedule {
  /// Frame of each event, in file order; -1 where it has none.
  std::vector<std::int64_t> frames;
  struct Faulty {
    std::size_t event;
    ScheduleFault fault;
  };
  std::vector<Faulty> faulty;
};

/// The frame of every event: its `step`, or for `at_s` the first frame whose start time t is
/// >= at_s - 1e-9 * dt, with dt the clock's base, or that frame's in a trace. Hitches move the
/// times of all later frames. Takes time in proportion to the frames only under jitter or a trace.
/// REQUIRES: numbers within the limits of scenario.h; `steps` = step_count(scenario).
[[nodiscard]] Schedule schedule_events(const Scenario& scenario, std::int64_t steps);

}  // namespace hyrax
