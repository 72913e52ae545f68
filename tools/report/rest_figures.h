// Pictures of how a sprite comes to rest.
#pragma once

#include <string>
#include <vector>

#include "sim/study/rest/rest_map.h"

namespace hyrax {

/// Parts of the flings that end at rest, in the cycle or in the buzz, against the rate, with the analytic
/// boundaries.
[[nodiscard]] std::string rest_map_script(const std::vector<RateEnds>& map,
                                          const std::vector<RestBoundary>& boundaries);
/// Time until it lies, against the rate.
[[nodiscard]] std::string rest_time_script(const std::vector<RateEnds>& map);
/// Effective restitution of a bounce against the phase of its contact, a line for each rate.
[[nodiscard]] std::string bounce_script(const std::vector<BounceSeen>& bounces);

}  // namespace hyrax
