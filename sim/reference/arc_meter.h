// Measures one flight arc after the other against the exact flights.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/motion/state.h"
#include "sim/reference/arc_cutter.h"
#include "sim/reference/arc_solution.h"
#include "sim/reference/double_double.h"
#include "sim/reference/drift.h"
#include "sim/reference/flight.h"
#include "sim/reference/largest.h"
#include "sim/reference/model.h"

namespace hyrax {

/// hyrax::time_of_impact, or another solution of the same.
using ImpactFinder = std::function<std::optional<Impact>(const Approach& approach, double t_max_s)>;

/// Keeps the last state of the arc and, for each wall, the first time at which the flight went out
/// through it, solved with the drag rate of the frame in which that happened. Along an axis it happens
/// once at most: horizontal speed keeps its sign, and vertical speed turns once, downwards.
class WallWatch {
 public:
  /// @param gravity_px_per_s2, log_air_drag of the matched ODE, whose rate is -log_air_drag / dt.
  WallWatch(double gravity_px_per_s2, double log_air_drag, ImpactFinder find)
      : gravity_(gravity_px_per_s2), log_air_drag_(log_air_drag), find_(std::move(find)) {}

  void start(const ArcStart& start);
  /// The matched ODE came to `now` in a frame of dt.
  void add(const State& now, double dt_s, double elapsed_s) {
    if (dt_s > 0.0) {
      if (is_any_outside_ || is_out(now) || may_touch_top(now, dt_s)) look(now, dt_s);
      rate_dt_s_ = dt_s;
    }
    last_ = now;
    last_elapsed_s_ = elapsed_s;
  }

  /// The impact on `wall`; its time counts from the arc's last row and is negative before it. Past
  /// that row the flight goes on with the rate of the last frame of positive dt, or of `clamped_dt_s`
  /// where there is none, for as long as `time_max_s` says.
  [[nodiscard]] std::optional<Impact> impact(Wall wall, double clamped_dt_s) const;
  /// How long past the last row a crossing still counts: the clamped frame and two frames of the rate.
  [[nodiscard]] double time_max_s(double clamped_dt_s) const {
    return clamped_dt_s + 2.0 * rate_dt_s(clamped_dt_s);
  }

 private:
  [[nodiscard]] bool is_out(const State& at) const {
    const auto& [left_px, right_px, top_px, bottom_px] = at_px_;
    return at.y_px > bottom_px || at.y_px < top_px || at.x_px > right_px || at.x_px < left_px;
  }
  // In the frame in which it turns downwards it can reach the top between two rows.
  [[nodiscard]] bool may_touch_top(const State& now, double dt_s) const {
    return last_.vy_px_per_s < 0.0 && now.vy_px_per_s >= 0.0 &&
           last_.y_px + last_.vy_px_per_s * dt_s < at_px_[wall_index(Wall::top)];
  }
  [[nodiscard]] double rate_dt_s(double clamped_dt_s) const {
    return rate_dt_s_ > 0.0 ? rate_dt_s_ : clamped_dt_s;
  }
  void look(const State& now, double dt_s);
  [[nodiscard]] Approach approach(Wall wall, const State& from, double dt_s) const;
  [[nodiscard]] std::optional<Impact> find(Wall wall, double dt_s, double t_max_s) const;

  double gravity_;
  double log_air_drag_;
  ImpactFinder find_;
  std::array<double, 4> at_px_{};  // Seen from the arc's first position.
  State last_;
  double last_elapsed_s_ = 0.0;
  double rate_dt_s_ = 0.0;            // Of the last frame in which time passed.
  std::array<bool, 4> is_outside_{};  // At the end of that frame.
  bool is_any_outside_ = false;
  std::array<std::optional<Impact>, 4> met_;
};

/// Everything that a measurement uses of the closed forms is compared, so that a mistake in any of them
/// is found in the run in which it would have counted. A NaN agrees with nothing.
class ReferenceCheck {
 public:
  /// The matched ODE at a row, by the closed form.
  struct Closed {
    const State& flight;
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
  /// What differs by more than drift.h allows, as in ArcErrors; empty: nothing.
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
  /// Of more contacts of a sprite that stays on the floor, and then leaves it without an input, statistics
  /// know nothing.
  static constexpr std::size_t kContactsOpenMax = 1 << 16;

  /// @param solver checks the closed form where it is not null. Refers to sink and solver.
  ArcMeter(const Model& model, DriftSink& sink, FlightSolver* solver);

  void begin(const ArcStart& start) override;
  void fly(const Row& row) override;
  void end(ArcEnd ended_by, const Row* clamped) override;
  void short_arc(const ArcStart& start, const Row* flown, const Row* clamped) override;

  /// Contacts from one on the ground on enter the statistics once it is known which of them are bounces: all
  /// since the last call, or without those on the ground from resting_from_step on that began before row
  /// end_step.
  void settle(std::int64_t end_step, std::optional<std::int64_t> resting_from_step);
  [[nodiscard]] bool has_contacts_to_settle() const { return !open_contacts_.empty(); }
  /// Without what the cutter knows: skipped arcs and the first row that is not finite.
  [[nodiscard]] DriftSummary summary() const {
    DriftSummary summary = summary_;
    summary.causes = causes_.now();
    return summary;
  }

 private:
  // What is gathered over the rows of one arc.
  struct Gathered {
    LargestDistance implementation, truncation, model, exact_law;
    LargestDistance implementation_speed, truncation_speed, exact_law_speed;
    LineFit drift_fit;
  };

  [[nodiscard]] double energy(const State& flight) const;
  [[nodiscard]] double gain(const State& from, const State& to) const {
    return energy_gain(from, to, model_.gravity_px_per_s2);
  }
  [[nodiscard]] Row step_from_last(double dt_s) const;
  [[nodiscard]] bool differs_from_listing(const Row& row) const;
  void tell_row(const State& run, const State& discrete, const State& matched, const Position& model);
  void open(const ArcStart& start, bool tells_rows);
  void close(ArcEnd ended_by, std::uint8_t walls, const Row* clamped, bool is_listed);
  void finish_errors(ArcEnd ended_by);
  void verify();
  [[nodiscard]] ImpactErrors impact_errors(Wall wall, const Row& clamped);
  [[nodiscard]] ContactEnergyParts contact_energy(const Row& clamped) const;
  [[nodiscard]] double bounce_error(Wall wall, double dt_s, double impact_speed_px_per_s) const;
  [[nodiscard]] double speed_after(Wall wall, const Row& clamped) const;
  [[nodiscard]] State seen_from_start(const Row& row) const;
  void count_fault();
  void report_arc();
  void report_contact(const ImpactErrors& contact, bool is_stopped);
  void include(const ImpactErrors& contact, bool is_stopped);

  Model model_;
  DriftSink& sink_;
  std::optional<ReferenceCheck> check_;
  bool wants_rows_;
  bool tells_rows_ = false;
  ArcSolution solution_;
  WallWatch walls_;
  ArcStart start_;
  State first_;
  Row last_;
  ArcErrors arc_;  // Of the arc so far.
  Gathered gathered_;
  LineFit drift_of_all_arcs_;
  struct OpenContact {
    ImpactErrors errors;
    bool is_stopped = false;
  };
  std::vector<OpenContact> open_contacts_;  // The first kContactsOpenMax,
  ArcEnergyParts open_arcs_;                // and the arcs since the first.
  EnergyCauseSum causes_;
  DriftSummary summary_;
};

}  // namespace hyrax
