// Where a run's sprite was given a velocity.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/columns.h"
#include "tools/report/sizes_in_force.h"

namespace hyrax {

/// A velocity given to the sprite: at the start, by a fling or by a release.
struct Throw {
  double x_px = 0.0;  ///< The sprite's centre.
  double y_px = 0.0;
  Velocity velocity;
};

/// In order of time; those in rows that are not recorded are left out.
/// @param frames the frame of each of the scenario's events.
[[nodiscard]] std::vector<Throw> throws_of(const Scenario& scenario, const std::vector<std::int64_t>& frames,
                                           const Columns& rows, const SizesInForce& sizes);

/// What the picture labels with its time: a grab, a release or a resize.
struct TimedInput {
  std::string_view what;
  double t_s = 0.0;
  double x_px = 0.0;  ///< The sprite's centre; of a window its right edge,
  double y_px = 0.0;  ///< and half its height.
};

/// In order of time; those in rows that are not recorded are left out, and of many resizes all but the first
/// and the last.
/// @param frames the frame of each of the scenario's events.
[[nodiscard]] std::vector<TimedInput> timed_inputs_of(const Scenario& scenario,
                                                      const std::vector<std::int64_t>& frames,
                                                      const Columns& rows, const SizesInForce& sizes);

[[nodiscard]] double speed_px_per_s(const Velocity& velocity);

}  // namespace hyrax
