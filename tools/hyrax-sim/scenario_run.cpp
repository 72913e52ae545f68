#include "tools/hyrax-sim/scenario_run.h"

#include <algorithm>
#include <filesystem>

#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "tools/hyrax-sim/golden_check.h"
#include "tools/hyrax-sim/progress.h"
#include "tools/store/golden_digest.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_place.h"
#include "tools/store/trajectory_format.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

RunSummary play_with_progress(const Scenario& scenario, RowSink& sink, const ReplayOptions& options) {
  Replay replay(scenario, sink, options);
  Progress progress("steps", replay.steps());
  constexpr std::int64_t kStepsBetweenLooks = 1 << 20;
  const std::int64_t stride = progress.is_shown() ? kStepsBetweenLooks : replay.steps();
  for (std::int64_t step = 0; step < replay.steps() && replay.keyframe().row.step == step;) {
    step = std::min(replay.steps(), step + stride);
    replay.play_to(step);
    progress.show(step);
  }
  return replay.finish();
}

// `steps` is shorter than the scenario where an earlier try found that the run ends there.
RunSummary play_into(const std::string& output, const Scenario& scenario, std::int64_t steps,
                     const ReplayOptions& options) {
  TrajectoryWriter writer(output, scenario, steps);
  const RunSummary summary = play_with_progress(scenario, writer, options);
  if (summary.steps != steps) return summary;
  std::int64_t contacts = 0;
  for (const std::int64_t count : summary.contacts) contacts += count;
  writer.finish({scenario, summary.steps, std::string(kPhysicsModel), hex(summary.state_hash)},
                inputs_taken(scenario, summary.steps), contacts);
  return summary;
}

// Where the digest names the run's hash all rows are equal, and nothing more is played or read.
Comparison compare_with_golden(const GoldenPlace& place, const Scenario& scenario,
                               const RunSummary& summary) {
  if (std::filesystem::exists(place.txt_path) && read_digest_hash(place.txt_path) == hex(summary.state_hash))
    return {};
  return compare_with(read_golden(place.h5_path), scenario).comparison;
}

}  // namespace

bool ScenarioRun::is_as_expected() const {
  const bool all_hold =
      std::all_of(expectations.begin(), expectations.end(), [](const auto& e) { return e.holds; });
  return all_hold && !summary.non_finite_step && (!comparison || comparison->agrees);
}

ScenarioRun run_scenario(const std::string& path, const Scenario& scenario, const std::string& output,
                         const ScenarioRunOptions& options) {
  ScenarioRun run;
  run.path = path;
  run.scenario = scenario;
  run.output = output;
  const ReplayOptions replay_options{.skips_repetition = options.skips_repetition,
                                     .checks_bounds = scenario.expect && scenario.expect->in_bounds};
  const std::int64_t steps = step_count(scenario);
  run.summary = play_into(output, scenario, steps, replay_options);
  if (run.summary.steps != steps)
    run.summary = play_into(output, scenario, run.summary.steps, replay_options);
  run.rows_recorded = TrajectoryWriter::row_count(run.summary.steps, scenario.record_every);
  if (scenario.expect) run.expectations = judge(*scenario.expect, run.summary);
  if (!options.compares) return run;
  const auto place = golden_place(path, options.golden_folder);
  if (place) run.golden_path = place->h5_path;
  if (place && std::filesystem::exists(place->h5_path))
    run.comparison = compare_with_golden(*place, scenario, run.summary);
  return run;
}

}  // namespace hyrax
