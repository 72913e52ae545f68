#include "sim/study/reference_model.h"

#include <fmt/format.h>

namespace hyrax {

std::string why_not_measurable(const Constants& constants) {
  const auto fault = [](const char* name, double value, double low, double high) {
    return value >= low && value <= high
               ? std::string()
               : fmt::format("{}: must be {} .. {} (found {})", name, low, high, value);
  };
  for (const std::string& found : {fault("GRAVITY", constants.gravity_px_per_s2, 0.0, 1e12),
                                   fault("AIR_DRAG", constants.air_drag, 0.5, 1.0),
                                   fault("RESTITUTION", constants.restitution, 0.0, 1.0),
                                   fault("GROUND_FRICTION", constants.ground_friction, 0.0, 1.0),
                                   fault("REST_THRESHOLD", constants.rest_threshold_px_per_s, 0.0, 1e12)})
    if (!found.empty()) return found;
  return "";
}

}  // namespace hyrax
