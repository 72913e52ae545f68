// Flight with linear drag, v' = g - k v, in closed form, and when it meets a wall.
#pragma once

#include <cassert>
#include <optional>

#include "sim/reference/phi.h"

namespace hyrax {

/// Displacement since the arc began, and velocity: the equations of flight know no origin, and a
/// displacement keeps the digits that a coordinate far from the origin has lost.
struct Flight {
  double dx_px = 0.0;
  double dy_px = 0.0;
  double vx_px_per_s = 0.0;
  double vy_px_per_s = 0.0;
};

/// Motion along one axis.
struct AxisMotion {
  double displacement_px = 0.0;
  double speed_px_per_s = 0.0;
};

/// Continuous closed form along one axis: with z = -k t,
///   displacement = v t phi1(z) + g t^2 phi2(z),   speed = v + z phi1(z) v + g t phi1(z).
/// Errors are below 1e-14 of |v| t + g t^2 / 2 and of |v| + g t (k t to 1e5 and beyond; k = 0 too).
/// REQUIRES: drag_rate_per_s >= 0, t_s >= 0.
[[nodiscard]] inline AxisMotion fly(double speed_px_per_s, double acceleration_px_per_s2,
                                    double drag_rate_per_s, double t_s) {
  assert(!(drag_rate_per_s < 0.0) && !(t_s < 0.0));
  const double z = -drag_rate_per_s * t_s;
  const Phi p = phi(z);
  const double gain_px_per_s = acceleration_px_per_s2 * t_s;
  return {t_s * (speed_px_per_s * p.one + gain_px_per_s * p.two),
          speed_px_per_s + z * p.one * speed_px_per_s + gain_px_per_s * p.one};
}

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
