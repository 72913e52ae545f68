// Measures one flight arc after the other against the exact flights.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "sim/reference/arc_cutter.h"
#include "sim/reference/arc_solution.h"
#include "sim/reference/double_double.h"
#include "sim/reference/drift.h"
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

/// Slope of a least-squares line with intercept, of values that come in.
class LineFit {
 public:
  void add(double t_s, double value) {
    ++count_;
    t_ += t_s;
    value_ += value;
    t_t_ += t_s * t_s;
    t_value_ += t_s * value;
  }
  /// Adds the values of another line, whose intercept is its own.
  void add_line(const LineFit& other) {
    if (other.count_ == 0.0) return;
    t_t_ += other.t_t_ - other.t_ * other.t_ / other.count_;
    t_value_ += other.t_value_ - other.t_ * other.value_ / other.count_;
    count_ = 1.0;
  }
  /// None where all t are equal.
  [[nodiscard]] std::optional<double> slope_per_s() const;

 private:
  double count_ = 0.0;
  double t_ = 0.0;
  double value_ = 0.0;
  double t_t_ = 0.0;
  double t_value_ = 0.0;
};

class ArcMeter final : public ArcVisitor {
 public:
  /// @param solver checks the closed form where it is not null. Refers to sink and solver.
  ArcMeter(const Model& model, DriftSink& sink, FlightSolver* solver);

  void begin(const ArcStart& start) override;
  void fly(const Row& row) override;
  void end(ArcEnd ended_by, const Row* clamped) override;
  void short_arc(const ArcStart& start, const Row* flown, const Row* clamped) override;

  /// Without what the cutter knows: skipped arcs and the first row that is not finite.
  [[nodiscard]] const DriftSummary& summary() const { return summary_; }

 private:
  // What is gathered over the rows of one arc.
  struct Gathered {
    LargestDistance implementation, truncation, model, exact_law;
    LargestDistance implementation_speed, truncation_speed, exact_law_speed;
    LineFit drift_fit;
    double energy_largest = 0.0;
    double drift_largest = 0.0;
    double drift_last = 0.0;
    double coordinate_largest_px = 0.0;
    std::int64_t differing_steps = 0;
  };

  struct ExactFlights {
    const Flight& discrete;
    const Flight& matched;
    const Position& model;
  };

  [[nodiscard]] double energy(const Flight& flight) const;
  [[nodiscard]] double energy_gain(const Flight& from, const Flight& to) const;
  [[nodiscard]] Row step_from_last(double dt_s) const;
  [[nodiscard]] bool differs_from_listing(const Row& row) const;
  void tell_row(const Flight& run, const ExactFlights& exact, double energy, double drift);
  void open(const ArcStart& start, bool tells_rows);
  void verify(ArcErrors& arc);
  [[nodiscard]] ArcErrors arc_errors(ArcEnd ended_by) const;
  [[nodiscard]] std::vector<ImpactErrors> contacts(std::uint8_t walls, const Row* clamped,
                                                   const ArcErrors& arc);
  [[nodiscard]] ImpactErrors impact_errors(Wall wall, const Row& clamped, const ArcErrors& arc);
  [[nodiscard]] ContactEnergyParts contact_energy(const Row& clamped) const;
  [[nodiscard]] double late_bounce(Wall wall, double dt_s, double impact_speed_px_per_s) const;
  [[nodiscard]] double speed_after(Wall wall, const Row& clamped) const;
  [[nodiscard]] double overshoot_px(Wall wall, double dt_s) const;
  [[nodiscard]] Flight seen_from_start(const Row& row) const;
  void count_fault(const ArcErrors& arc);
  void add_to_summary(const ArcErrors& arc);
  void add_to_summary(const ImpactErrors& contact, bool is_stopped);
  void report_contacts(const std::vector<ImpactErrors>& contacts, bool is_stopped);

  Model model_;
  DriftSink& sink_;
  std::optional<ReferenceCheck> check_;
  bool wants_rows_;
  bool tells_rows_ = false;
  ArcSolution solution_;
  WallWatch walls_;
  ArcStart start_;
  Flight first_;
  Row last_;
  Gathered gathered_;
  LineFit drift_of_all_arcs_;
  DriftSummary summary_;
};

}  // namespace hyrax
