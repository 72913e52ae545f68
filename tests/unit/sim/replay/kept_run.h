// Runs as golden files keep them.
#pragma once

#include "sim/core/core.h"
#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/physics_model.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

inline StoredRun kept_run(const Scenario& scenario, const Core& core = shipped_core()) {
  RunRecorder recorder(step_count(scenario));
  const RunSummary summary = replay(core, scenario, recorder);
  StoredRun run = recorder.take();
  run.scenario = scenario;
  run.physics = kPhysicsModel;
  run.constants = core.constants;
  run.steps = summary.steps;
  run.state_hash = hex(summary.state_hash);
  run.final = summary.final;
  run.contacts_total = static_cast<std::int64_t>(run.contacts.size());
  run.inputs = inputs_of(scenario, summary.steps);
  return run;
}

}  // namespace hyrax
