#include "tools/hyrax-sim/golden_check.h"

#include <algorithm>

#include "sim/compare/run_comparer.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {
namespace {

ReplayOptions options_for(const Scenario& scenario) {
  return {.checks_bounds = scenario.expect && scenario.expect->in_bounds};
}

// Takes one block's rows.
class BlockSink : public RowSink {
 public:
  explicit BlockSink(RowBlock& rows) : rows_(rows) {}
  [[nodiscard]] Wants wants() const override { return {.blocks = true}; }
  void block(const Block& block, std::int64_t) override {
    if (rows_.size() == 0) rows_.append(block.rows, 0, block.rows.size());
  }

 private:
  RowBlock& rows_;
};

// Plays a kept block anew from its keyframe.
RowBlock expand(const Scenario& scenario, const StoredBlock& kept) {
  RowBlock rows;
  BlockSink sink(rows);
  Replay replay(scenario, kept.keyframe, sink);
  replay.play_to(
      std::min(replay.steps(), kept.keyframe.row.step + static_cast<std::int64_t>(kBlockRows) - 1));
  static_cast<void>(replay.finish());
  return rows;
}

}  // namespace

std::vector<Input> inputs_taken(const Scenario& scenario, std::int64_t steps) {
  return inputs_of(scenario, schedule_events(scenario, step_count(scenario)).frames, steps);
}

ComparedRun compare_with(const StoredRun& kept, const Scenario& scenario) {
  RunComparer comparer(kept, [&](const StoredBlock& block) { return expand(scenario, block); });
  const RunSummary summary = replay(scenario, comparer, options_for(scenario));
  return {comparer.finish({scenario, summary.steps, kPhysicsModel, hex(summary.state_hash), summary.final,
                           inputs_taken(scenario, summary.steps)}),
          summary};
}

RunSummary play(const Scenario& scenario) {
  RowSink nothing_wanted;
  return replay(scenario, nothing_wanted, options_for(scenario));
}

FreshRun play_for_golden(const Scenario& scenario) {
  RunRecorder recorder(step_count(scenario));
  const RunSummary summary = replay(scenario, recorder, options_for(scenario));
  StoredRun run = recorder.take();
  run.scenario = scenario;
  run.physics = kPhysicsModel;
  run.steps = summary.steps;
  run.state_hash = hex(summary.state_hash);
  run.final = summary.final;
  for (const std::int64_t count : summary.contacts) run.contacts_total += count;
  run.inputs = inputs_taken(scenario, summary.steps);
  return {std::move(run), summary};
}

}  // namespace hyrax
