// Checks every step of a run against the invariants that a step can break.
#pragma once

#include <algorithm>
#include <functional>

#include "sim/core/core.h"
#include "sim/search/invariant.h"
#include "sim/trajectory/input_playback.h"
#include "sim/trajectory/row_sink.h"

namespace hyrax {

/// A sink for a run from its start. Its bounds are derived, above the code that computes them, from
/// the laws alone: gravity G >= 0 and the step's factors, none of them above 1. Of a core with another step
/// it checks only that it stays finite and inside.
class StepWatch : public RowSink {
 public:
  /// Refers to the core and the scenario. @param report_steps see check_run.
  StepWatch(const Core& core, const Scenario& scenario,
            const std::function<void(std::int64_t)>& report_steps = {});

  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void row(const Row& row) override;

  [[nodiscard]] const InvariantMeasures& measures() const { return measures_; }
  /// The larger of both speeds' magnitudes, in the last two rows: a cycle at rest has one row of speed 0.
  [[nodiscard]] double last_speed_px_per_s() const {
    return std::max(speed_px_per_s_, speed_before_px_per_s_);
  }
  /// Decisions of a wall within rounding of its bound, which the mirrored run took the other way.
  [[nodiscard]] std::int64_t knife_edges() const { return knife_edges_; }

 private:
  // One step: from a state with the frame's inputs applied, by the flight without walls, to the row.
  struct Step {
    State from;
    State flight;
    const Row& row;
    Bounds bounds;
  };

  void start_from(const State& body, Bounds bounds);
  void check_finite(const Row& row);
  void check_bounds(const Step& step);
  void check_step_energy(const Step& step);
  void check_energy_ceiling(const Step& step);
  void check_speed(const Step& step);
  void check_listing(const Step& step);
  void check_mirror(const Step& step);
  void check_no_time(const Step& step);
  void record(Invariant invariant, double slack, std::int64_t step) {
    measures_[static_cast<std::size_t>(invariant)].add(slack, step);
  }
  void mirror(const State& body, Bounds bounds);

  const Core& core_;
  std::function<void(std::int64_t)> report_steps_;
  Constants constants_;
  InputPlayback inputs_;
  InvariantMeasures measures_{};
  Row before_;
  Bounds bounds_;
  bool has_row_ = false;
  double largest_ = 0.0;  // Of all numbers yet.
  double speed_px_per_s_ = 0.0;
  double speed_before_px_per_s_ = 0.0;

  // Since the last input.
  std::int64_t steps_ = 0;
  double dt_min_s_ = 0.0;
  double dt_max_s_ = 0.0;
  double energy_y_start_px2_per_s2_ = 0.0;
  double vx_max_px_per_s_ = 0.0;
  double vy_max_px_per_s_ = 0.0;

  State mirrored_;
  double mirror_slack_px_ = 0.0;
  std::int64_t knife_edges_ = 0;
};

}  // namespace hyrax
