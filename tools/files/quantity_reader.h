// The quantities that stand in several places of a scenario document, with their limits.
#pragma once

#include "sim/scenario/scenario.h"
#include "tools/files/json_reader.h"

namespace hyrax {

inline constexpr NumberRule kCoordinateRule{-kCoordinateMax_px, kCoordinateMax_px};
inline constexpr NumberRule kSpeedRule{-kSpeedMax_px_per_s, kSpeedMax_px_per_s};
inline constexpr NumberRule kFrameRule{0.0, kFrameMax_s};
inline constexpr NumberRule kNotNegativeRule{0.0};

// What is wrong is told to the place, and reads as 0.
[[nodiscard]] Size read_window(const JsonPlace& here);
[[nodiscard]] Size read_sprite(const JsonPlace& here);
/// Of an object that may hold more than x_px and y_px.
[[nodiscard]] Position read_position(const JsonPlace& here);
[[nodiscard]] Velocity read_velocity(const JsonPlace& here);

}  // namespace hyrax
