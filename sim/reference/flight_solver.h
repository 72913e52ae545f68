// A second solution of an arc, to check the closed forms by.
#pragma once

#include <optional>

#include "sim/reference/flight.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

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
