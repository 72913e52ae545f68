// When a flight meets a wall.
#pragma once

#include <optional>

namespace hyrax {

/// One axis of a flight at a constant drag rate, seen from a wall: position and speed grow outwards,
/// and past the wall the position is positive.
struct Approach {
  double position_px = 0.0;
  double speed_px_per_s = 0.0;
  double acceleration_px_per_s2 = 0.0;
  double drag_rate_per_s = 0.0;  ///< >= 0.
};

struct Impact {
  double t_s = 0.0;
  double speed_px_per_s = 0.0;   ///< Outwards, >= 0.
  double drag_rate_per_s = 0.0;  ///< That it was solved with.
};

/// The first time in 0 .. t_max_s at which the flight comes from inside and goes out through the
/// wall. Bracketed, so that it is found whenever it is there; the root of the closed form to a few
/// units in the last place.
[[nodiscard]] std::optional<Impact> time_of_impact(const Approach& approach, double t_max_s);

}  // namespace hyrax
