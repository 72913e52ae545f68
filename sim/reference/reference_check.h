// Holds what the closed forms say of an arc to a second solution of it.
#pragma once

#include <optional>
#include <string_view>

#include "sim/reference/arc_cutter.h"
#include "sim/reference/double_double.h"
#include "sim/reference/flight_solver.h"
#include "sim/reference/largest.h"
#include "sim/reference/model.h"
#include "sim/reference/wall_watch.h"

namespace hyrax {

/// Everything that a measurement uses of the closed forms is compared, so that a mistake in any of them
/// is found in the run in which it would have counted. A NaN agrees with nothing.
class ReferenceCheck {
 public:
  /// The matched ODE at a row, by the closed form.
  struct Closed {
    const Flight& flight;
    double energy_px2_per_s2 = 0.0;
    double energy_gain_px2_per_s2 = 0.0;  ///< Since the arc's first row.
  };

  /// Refers to the solver.
  ReferenceCheck(const Model& model, FlightSolver& solver);

  void start(const ArcStart& start, bool solves_x, double energy_px2_per_s2);
  /// Compares position, velocity and energy after one more frame. By the work-energy theorem the energy
  /// can only change by what drag takes, which is summed up from the solver's velocities.
  void check_row(const Closed& closed, double dt_s, double elapsed_s);
  /// Compares the flight at the drag rate of the model, t_s after the arc's first row.
  void check_model(const Position& displacement, double t_s);
  /// Compares where the flight goes out through `wall`.
  void check_impact(Wall wall, double clamped_dt_s, const std::optional<Impact>& closed);

  /// The largest distance of both solutions in px: of rows, and of the model's last position. None
  /// where the solver failed.
  [[nodiscard]] std::optional<double> apart_px() const;
  /// What differs by more than drift.h allows, as in ArcErrors; empty: nothing, or the solver is no judge.
  [[nodiscard]] std::string_view fault(double coordinate_largest_px) const;

 private:
  struct Gathered {
    LargestDistance position, velocity, model;
    double energy_px2_per_s2 = 0.0;
    double impact_px = 0.0;  // Time times speed.
    double impact_px_per_s = 0.0;
    double flown_px = 0.0;  // From the last row to an impact: at most.
    double speed_largest_squared = 0.0;
    double energy_largest_px2_per_s2 = 0.0;
    double elapsed_s = 0.0;
    bool has_failed = false;
  };
  [[nodiscard]] double drag_loss(const Velocity& from, const Velocity& to, double dt_s) const;
  void include_sizes(double speed_squared, double energy_px2_per_s2);
  void include_flown(const Impact& impact);

  FlightSolver& solver_;
  double gravity_;
  double drag_;  // -ln(air_drag).
  WallWatch walls_;
  Velocity last_;
  DoubleDouble drag_taken_;
  double first_energy_ = 0.0;
  Gathered gathered_;
};

}  // namespace hyrax
