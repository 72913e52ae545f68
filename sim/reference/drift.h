// What a run's flight arcs and contacts are worth against the reference: values, no text.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/motion/state.h"
#include "sim/reference/arc_cutter.h"
#include "sim/reference/model.h"

namespace hyrax {

/// The two solutions of an arc may differ by kSolversApart_px + kSolversApart_rel times the arc's
/// largest coordinate, their velocities by kSolversApart_px_per_s + kSolversApart_rel times its largest
/// speed, and the energy of the closed form from what drag leaves of it by kSolversApartEnergy_rel of
/// the sum of kSolversApartEnergyMin, the largest v^2 and the largest energy. Impacts may differ by
/// kSolversApart_rel of the way flown in the clamped frame more. Beyond that it is a fault of the
/// reference, never of the run.
inline constexpr double kSolversApart_px = 1e-9;
inline constexpr double kSolversApart_px_per_s = 1e-9;
inline constexpr double kSolversApart_rel = 1e-13;
inline constexpr double kSolversApartEnergy_rel = 1e-9;

inline constexpr double kSolversApartEnergyMin_px2_per_s2 = Model{}.gravity_px_per_s2;

/// How an arc's energy drift at its last row came about, px^2/s^2: by the discretisation of gravity, which
/// costs the same whatever the speed, and by drag along the path that follows from it. Their sum is the
/// drift.
struct ArcEnergyParts {
  double gravity = 0.0;
  double drag = 0.0;
  ArcEnergyParts& operator+=(const ArcEnergyParts& other) {
    gravity += other.gravity;
    drag += other.drag;
    return *this;
  }
};

/// The energy change of a clamped step in the order of its operations, px^2/s^2: the flight without walls,
/// the lift out of the wall, restitution, friction, the rest rule. In a corner lift and bounce hold both
/// walls.
struct ContactEnergyParts {
  double flight = 0.0;
  double lift = 0.0;
  double bounce = 0.0;
  double friction = 0.0;
  double rest = 0.0;
  ContactEnergyParts& operator+=(const ContactEnergyParts& other) {
    flight += other.flight;
    lift += other.lift;
    bounce += other.bounce;
    friction += other.friction;
    rest += other.rest;
    return *this;
  }
};

/// One flight arc against the exact flights from its first state.
///
/// Each distance is the largest hypot(dx, dy) over the arc's rows, each speed error the largest
/// hypot(dvx, dvy). With e = (vx^2 + vy^2) / 2 + g (bottom - y), the drift is e of the run minus e
/// of the matched ODE at the same moment, in the form that does not cancel; relative: divided by
/// energy_scale_px2_per_s2.
struct ArcErrors {
  std::int64_t first_step = 0;  ///< Row numbers.
  std::int64_t last_step = 0;
  double t_s = 0.0;  ///< Of the last row.
  double duration_s = 0.0;
  ArcEnd ended_by = ArcEnd::end;
  bool solves_x = true;  ///< False: no horizontal motion, and nothing was solved in x.

  double implementation_px = 0.0;  ///< Against the discrete closed form: rounding, if the code is right.
  double truncation_px = 0.0;      ///< Against the matched ODE.
  double model_px = 0.0;           ///< Against the ODE with the drag rate of 60 Hz.
  double implementation_px_per_s = 0.0;
  double truncation_px_per_s = 0.0;
  double exact_law_px = 0.0;  ///< Against the flow of the exact law of the step: rounding.
  double exact_law_px_per_s = 0.0;

  /// Steps that are not the paper's step of the row before, done in strict double arithmetic: a
  /// fused or reordered operation shows here, where its size would pass for rounding.
  std::int64_t differing_steps = 0;

  double energy_largest_px2_per_s2 = 0.0;  ///< Of the matched ODE.
  /// What relative energies are divided by: the largest, or the energy of 1 px of height where that is more,
  /// so that arcs of almost no energy do not drown the rest; 1 where both are 0.
  double energy_scale_px2_per_s2 = 1.0;
  double energy_drift_max_px2_per_s2 = 0.0;  ///< Magnitude.
  double energy_drift_end_px2_per_s2 = 0.0;  ///< Signed, at last_step.
  double energy_drift_rel_max = 0.0;
  double energy_drift_rel_end = 0.0;
  /// Least-squares slope with intercept of the signed drift, none where no time passes: as height (divided by
  /// gravity; none without it), the same for every arc of a clock, and relative, which says how low an arc
  /// is.
  std::optional<double> energy_drift_slope_px_per_s = {};
  std::optional<double> energy_drift_slope_per_s = {};
  ArcEnergyParts energy_parts = {};

  double coordinate_largest_px = 0.0;           ///< Of the run and the matched ODE.
  std::optional<double> gsl_vs_closed_px = {};  ///< None without a second solver, or where it failed.
  /// What is wrong with the reference; empty: nothing. "position differs", of the two solutions, or
  /// "velocity", "energy", "model error", or "time of impact" of the contact that ended the arc; "the
  /// second solver failed"; "a value is not finite".
  std::string_view reference_fault = {};
};

/// A contact that ended an arc, of no step too, against the true impact: the first time t* at which the
/// matched ODE from the arc's first state goes out through that wall. It flies with each frame's own rate,
/// and past the last row with that of the arc's last frame of positive dt (of the clamped frame, if there is
/// none). None where it does not cross within the clamped dt plus twice that last dt.
struct ImpactErrors {
  std::int64_t step = 0;  ///< Of the clamped row.
  double t_s = 0.0;
  Wall wall = Wall::ground;
  std::optional<double> time_error_s = {};  ///< t of the clamped row minus t*.
  double overshoot_px = 0.0;                ///< How far past the wall the unclamped position was, >= 0.
  double energy_jump_px2_per_s2 = 0.0;      ///< Energy change over the clamped step,
  double energy_jump_rel = 0.0;             ///< and that / the arc's scale.
  std::optional<double> effective_restitution = {};  ///< Normal speed after that wall / normal speed at t*.
  ContactEnergyParts energy_parts = {};              ///< In a corner the same for both walls.
  bool is_second_of_corner = false;
  /// What the clamped frame adds to the listed arc's energy drift by its flight, before the wall is asked
  /// for.
  double flight_error_px2_per_s2 = 0.0;
  /// What restitution at the end of the step, early or late, takes more than at t*, px^2/s^2, signed: with r
  /// the ratio of speeds, -(1 - r^2) / 2 (speed^2 at the step's end - speed^2 at t*), of the normal speed.
  std::optional<double> bounce_error_px2_per_s2 = {};
};

/// How the energy drift of flights and bounces came about, as the height in px that it lifts the sprite by:
/// gravity once a step, drag on that path, the lift out of walls, restitution after the wall instead of at
/// it; and what these do not explain, the flight within the frames of contacts.
struct EnergyCauses {
  double gravity = 0.0;
  double drag = 0.0;
  double lift = 0.0;
  double bounce = 0.0;
  double flight = 0.0;

  /// What is explained.
  [[nodiscard]] double sum() const { return gravity + drag + lift + bounce; }
};

/// A row of an arc against the exact flights. Rows of an arc come in order, its first row included.
struct RowErrors {
  std::int64_t step = 0;
  double t_s = 0.0;
  double x_px = 0.0;  ///< The matched ODE.
  double y_px = 0.0;
  double vx_px_per_s = 0.0;
  double vy_px_per_s = 0.0;
  double implementation_px = 0.0;
  double truncation_px = 0.0;
  double model_px = 0.0;
  double energy_px2_per_s2 = 0.0;        ///< Of the matched ODE.
  double energy_drift_px2_per_s2 = 0.0;  ///< Run minus matched ODE.
};

/// Receives what is measured: the rows of an arc, then the arc, then the contacts that ended it (two in
/// a corner, x before y). Of a shorter arc, the contacts that begin after it alone.
class DriftSink {
 public:
  DriftSink() = default;
  DriftSink(const DriftSink&) = delete;
  DriftSink& operator=(const DriftSink&) = delete;
  virtual ~DriftSink() = default;

  /// Asked once; rows cost more than arcs.
  [[nodiscard]] virtual bool wants_rows() const { return false; }
  virtual void row(const RowErrors& /*row*/) {}
  virtual void arc(const ArcErrors& /*arc*/) {}
  virtual void contact(const ImpactErrors& /*contact*/) {}
};

/// A largest value and the arc it comes from, by the arc's first_step, or the contact, by its step.
struct Worst {
  double value = 0.0;
  std::int64_t step = 0;
};

/// Median and range as values come in, which one value, however far off, does not move.
class Spread {
 public:
  void add(double value);
  [[nodiscard]] std::int64_t count() const { return count_; }
  /// REQUIRES: count() > 0, of all three. The median is that of every K-th value, K = 1 up to kKeptMax
  /// values.
  [[nodiscard]] double median() const;
  [[nodiscard]] double smallest() const { return smallest_; }
  [[nodiscard]] double largest() const { return largest_; }

  static constexpr std::size_t kKeptMax = 1 << 16;

 private:
  std::int64_t count_ = 0;
  double smallest_ = std::numeric_limits<double>::infinity();
  double largest_ = -std::numeric_limits<double>::infinity();
  std::vector<double> kept_;
  std::int64_t kept_every_ = 1;
};

/// The run as a whole. What no arc or contact had is none.
struct DriftSummary {
  std::int64_t arcs = 0;
  std::int64_t skipped_arcs = 0;
  std::int64_t contacts = 0;
  std::int64_t arcs_without_x = 0;  ///< Arcs in which nothing was solved in x.
  std::int64_t differing_steps = 0;
  std::int64_t reference_faults = 0;  ///< Arcs, of one step too; any is a fault of the program.
  std::optional<std::int64_t> first_reference_fault_step;
  std::string_view first_reference_fault;       ///< ArcErrors::reference_fault.
  std::optional<std::int64_t> non_finite_step;  ///< Nothing from this row on was measured.

  std::optional<Worst> implementation_px;
  std::optional<Worst> truncation_px;
  std::optional<Worst> model_px;
  std::optional<Worst> exact_law_px;
  std::optional<Worst> energy_drift_rel_max;
  std::optional<Worst> energy_drift_max_px2_per_s2;
  std::optional<Worst> energy_drift_slope_px_per_s;  ///< The steepest, with its sign.
  std::optional<Worst> energy_drift_slope_per_s;     ///< The same.
  /// Least-squares slope of the drift as height over the rows of all arcs, each with an intercept of its own.
  std::optional<double> secular_px_per_s;
  std::optional<Worst> gsl_vs_closed_px;
  std::optional<Worst> time_error_s;  ///< The largest in magnitude, with its sign.
  std::optional<Worst> overshoot_px;
  std::optional<Worst> energy_jump_rel;  ///< The largest in magnitude, with its sign.
  EnergyCauses causes;                   ///< Of bounces, and of arcs without those between resting contacts.
  /// Energy changes: of the matched ODE along the arcs, and of the run in rows that no arc and no contact has
  /// (arcs of one step, frames in which a contact goes on). With the parts of arcs and contacts they add up
  /// to that of the run without its inputs.
  double reference_energy_px2_per_s2 = 0.0;
  double unlisted_energy_px2_per_s2 = 0.0;
  Spread effective_restitution;
  struct Rest {
    double from_s = 0.0;
    double to_s = 0.0;
  };
  std::vector<Rest> rests;         ///< When the sprite was in resting contact: the first kRestsMax times,
  bool is_resting_at_end = false;  ///< and whether the last of them goes on to the end.
  static constexpr std::size_t kRestsMax = 1000;

  [[nodiscard]] bool is_at_rest(double t_s) const {
    for (const Rest& rest : rests)
      if (rest.from_s <= t_s && (t_s < rest.to_s || (is_resting_at_end && &rest == &rests.back())))
        return true;
    return false;
  }
};

/// Sums up EnergyCauses over arcs and contacts.
class EnergyCauseSum {
 public:
  /// REQUIRES: gravity > 0 where heights are asked for.
  explicit EnergyCauseSum(double gravity_px_per_s2) : gravity_px_per_s2_(gravity_px_per_s2) {}
  [[nodiscard]] const EnergyCauses& now() const { return now_; }
  void add(const ArcEnergyParts& arc) {
    now_.gravity += height(arc.gravity);
    now_.drag += height(arc.drag);
  }
  void add(const ImpactErrors& contact) {
    now_.bounce += height(contact.bounce_error_px2_per_s2.value_or(0.0));
    if (contact.is_second_of_corner) return;
    now_.lift += height(contact.energy_parts.lift);
    now_.flight += height(contact.flight_error_px2_per_s2);
  }

 private:
  [[nodiscard]] double height(double energy_px2_per_s2) const {
    return energy_px2_per_s2 / gravity_px_per_s2_;
  }

  double gravity_px_per_s2_;
  EnergyCauses now_;
};

}  // namespace hyrax
