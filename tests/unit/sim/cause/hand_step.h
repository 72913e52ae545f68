// Steps written by hand, as somebody would edit the core, and runs of them.
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "sim/core/core.h"
#include "sim/core/kernel_of.h"
#include "sim/core/listing_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/stored_run.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {

inline constexpr Constants kPaper{1200.0, 0.6, 0.999, 0.8, 5.0};

/// The listing in parts, each of which a test can write again.
struct HandStep {
  using Part = std::function<void(State&, double dt_s)>;
  using Walls = std::function<void(State&, const Bounds&)>;

  Constants constants = kPaper;
  Part fly = [this](State& s, double dt_s) {
    s.vy_px_per_s += constants.gravity_px_per_s2 * dt_s;
    s.vx_px_per_s *= constants.air_drag;
    s.vy_px_per_s *= constants.air_drag;
    s.x_px += s.vx_px_per_s * dt_s;
    s.y_px += s.vy_px_per_s * dt_s;
  };
  Walls walls_in_x = [this](State& s, const Bounds& bounds) {
    if (s.x_px < 0.0) {
      s.x_px = 0.0;
      s.vx_px_per_s = -s.vx_px_per_s * constants.restitution;
    } else if (s.x_px > bounds.right_px) {
      s.x_px = bounds.right_px;
      s.vx_px_per_s = -s.vx_px_per_s * constants.restitution;
    }
  };
  std::function<void(State&)> top = [this](State& s) {
    s.y_px = 0.0;
    s.vy_px_per_s = -s.vy_px_per_s * constants.restitution;
  };
  Walls ground = [this](State& s, const Bounds& bounds) {
    s.y_px = bounds.bottom_px;
    s.vy_px_per_s = -s.vy_px_per_s * constants.restitution;
    s.vx_px_per_s *= constants.ground_friction;
    if (std::fabs(s.vy_px_per_s) < constants.rest_threshold_px_per_s) s.vy_px_per_s = 0.0;
  };
  bool has_y_walls_first = false;

  HandStep() = default;
  HandStep(const HandStep&) = delete;
  HandStep& operator=(const HandStep&) = delete;

  void operator()(State& s, double dt_s, const Bounds& bounds) const {
    fly(s, dt_s);
    if (!has_y_walls_first) walls_in_x(s, bounds);
    if (s.y_px < 0.0)
      top(s);
    else if (s.y_px > bounds.bottom_px)
      ground(s, bounds);
    if (has_y_walls_first) walls_in_x(s, bounds);
  }
};

/// Cores with that step.
struct HandCores : StepCores<std::reference_wrapper<const HandStep>> {
  [[nodiscard]] Constants constants() const { return step.get().constants; }
};

/// Refers to the step.
inline Core hand_core(const HandStep& step) {
  return {.kernel = std::make_shared<const KernelOf<HandCores>>(HandCores{{step}})};
}

/// The run of a scenario with that step, as a golden file keeps it.
inline StoredRun run_of(const Scenario& scenario, const HandStep& step = HandStep()) {
  RunRecorder recorder(step_count(scenario));
  const RunSummary summary = replay(hand_core(step), scenario, recorder);
  StoredRun run = recorder.take();
  run.scenario = scenario;
  run.constants = step.constants;
  run.steps = summary.steps;
  run.state_hash = hex(summary.state_hash);
  run.final = summary.final;
  run.contacts_total = static_cast<std::int64_t>(run.contacts.size());
  run.inputs = inputs_of(scenario, summary.steps);
  return run;
}

}  // namespace hyrax
