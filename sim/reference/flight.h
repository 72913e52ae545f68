// Flight with linear drag, v' = g - k v, in closed form, and when it meets a wall.
#pragma once

#include <cassert>
#include <optional>

#include "sim/motion/state.h"
#include "sim/reference/phi.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

// A State of a flight has its position from where the arc began: the equations of flight know no origin, and
// a displacement keeps the digits that a coordinate far from the origin has lost.

/// Specific energy gained between two states, px^2/s^2, of e = (vx^2 + vy^2) / 2 - g y. As
/// (v - w)(v + w) / 2 - g (y - z): two large energies are never subtracted.
[[nodiscard]] inline double energy_gain(const State& from, const State& to, double gravity_px_per_s2) {
  const double kinetic_x = (to.vx_px_per_s - from.vx_px_per_s) * (to.vx_px_per_s + from.vx_px_per_s);
  const double kinetic_y = (to.vy_px_per_s - from.vy_px_per_s) * (to.vy_px_per_s + from.vy_px_per_s);
  return 0.5 * (kinetic_x + kinetic_y) - gravity_px_per_s2 * (to.y_px - from.y_px);
}

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

/// Whether a wall is met in x.
[[nodiscard]] constexpr bool is_at_side(Wall wall) { return wall == Wall::left || wall == Wall::right; }

/// One axis of a flight at a constant drag rate, seen from a wall: position and speed grow outwards,
/// and past the wall the position is positive.
struct Approach {
  double position_px = 0.0;
  double speed_px_per_s = 0.0;
  double acceleration_px_per_s2 = 0.0;
  double drag_rate_per_s = 0.0;  ///< >= 0.
};

/// Where a wall is, within bounds.
[[nodiscard]] constexpr double place_px(Wall wall, const Bounds& bounds) {
  if (wall == Wall::left || wall == Wall::top) return 0.0;
  return wall == Wall::right ? bounds.right_px : bounds.bottom_px;
}

/// A flight from a state, as the wall at wall_px sees it.
[[nodiscard]] constexpr Approach approach_to(Wall wall, double wall_px, const State& from,
                                             double gravity_px_per_s2, double drag_rate_per_s) {
  const double outwards = wall == Wall::left || wall == Wall::top ? -1.0 : 1.0;
  if (is_at_side(wall))
    return {outwards * (from.x_px - wall_px), outwards * from.vx_px_per_s, 0.0, drag_rate_per_s};
  return {outwards * (from.y_px - wall_px), outwards * from.vy_px_per_s, outwards * gravity_px_per_s2,
          drag_rate_per_s};
}

struct Impact {
  double t_s = 0.0;
  double speed_px_per_s = 0.0;   ///< Outwards, >= 0.
  double drag_rate_per_s = 0.0;  ///< That it was solved with.
};

/// The first time in 0 .. t_max_s at which the flight comes from inside and goes out through the
/// wall. Bracketed, so that it is found whenever it is there; the root of the closed form to a few
/// units in the last place.
[[nodiscard]] std::optional<Impact> time_of_impact(const Approach& approach, double t_max_s);

/// Solves v' = g - k v frame by frame, k = -ln(air_drag) / dt of each frame (a frame of dt 0 only
/// damps), and at fixed rates.
class FlightSolver {
 public:
  FlightSolver() = default;
  FlightSolver(const FlightSolver&) = delete;
  FlightSolver& operator=(const FlightSolver&) = delete;
  virtual ~FlightSolver() = default;

  /// Begins an arc and forgets the last one. Without `solves_x`, x and vx stay 0.
  virtual void start(const Velocity& velocity, bool solves_x) = 0;
  /// Flies one frame on, to the flight that it gives. Nothing where the solver failed or a value in or out is
  /// not finite; then the arc has no solution any more.
  [[nodiscard]] virtual std::optional<State> advance(double dt_s) = 0;

  /// The displacement from the arc's start through t_s at the drag rate of the model, independent of the
  /// frames. Nothing if the solver failed.
  [[nodiscard]] virtual std::optional<Position> model(double t_s) = 0;
  /// As hyrax::time_of_impact. A solver that failed returns NaN.
  [[nodiscard]] virtual std::optional<Impact> time_of_impact(const Approach& approach, double t_max_s) = 0;
};

}  // namespace hyrax
