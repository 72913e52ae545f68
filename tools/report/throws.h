// Where a run's sprite was given a velocity.
#pragma once

#include <cstdint>
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

[[nodiscard]] double speed_px_per_s(const Velocity& velocity);

}  // namespace hyrax
