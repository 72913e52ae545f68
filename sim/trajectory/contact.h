// A run of consecutive steps clamped by the same wall.
#pragma once

#include <cstdint>

#include "sim/motion/state.h"

namespace hyrax {

/// A bounce is a contact of one step; rest on the floor is one that does not end. All quantities
/// but `last_step` are of its first step.
struct Contact {
  std::int64_t step = 0;
  std::int64_t last_step = 0;
  Wall wall = Wall::ground;
  double t_s = 0.0;
  double x_px = 0.0;
  double y_px = 0.0;
  double vx_before_px_per_s = 0.0;  ///< After gravity and drag, as it met the wall.
  double vy_before_px_per_s = 0.0;
  double vx_after_px_per_s = 0.0;
  double vy_after_px_per_s = 0.0;
  /// >= 0; how far past the wall the unclamped position was. NaN: not known, of a core of one's own.
  double overshoot_px = 0.0;
  bool operator==(const Contact&) const = default;
};

/// A trajectory holds no more contacts than this; they are counted all the same.
inline constexpr std::int64_t kContactsRecordedMax = 1'000'000;

}  // namespace hyrax
