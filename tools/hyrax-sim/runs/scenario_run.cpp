#include "tools/hyrax-sim/runs/scenario_run.h"

#include <algorithm>

#include "tools/hyrax-sim/golden/golden_pair.h"
#include "tools/hyrax-sim/runs/run_expectations.h"

namespace hyrax {

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
  const bool checks_bounds = scenario.expect && scenario.expect->in_bounds;
  WrittenRun written =
      write_run(output, scenario,
                {.replay = {.skips_repetition = options.skips_repetition, .checks_bounds = checks_bounds},
                 .drift = options.drift});
  run.summary = written.summary;
  run.rows_recorded = written.rows_recorded;
  run.drift = std::move(written.drift);
  run.expectations = judge_run(scenario, run.summary);
  const auto place = golden_place(path, options.golden_folder);
  if (!options.compares || !place) {
    run.not_compared = place ? "values were set" : "no folder `scenarios` above it; --golden DIR names one";
    return run;
  }
  run.golden_path = place->h5_path;
  run.golden_folder = options.golden_folder;
  if (has_golden_file(*place)) run.comparison = compare_with_pair(scenario, *place, true)->comparison;
  return run;
}

}  // namespace hyrax
