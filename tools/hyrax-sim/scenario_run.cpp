#include "tools/hyrax-sim/scenario_run.h"

#include <algorithm>

#include "tools/files/presence.h"
#include "tools/files/text_file.h"
#include "tools/hyrax-sim/golden_check.h"
#include "tools/hyrax-sim/run_expectations.h"
#include "tools/store/golden_digest.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_place.h"
#include "tools/store/golden_seal.h"

namespace hyrax {
namespace {

// Where the digest is of the golden file and names the run's hash all rows are equal, and nothing
// more is played or read.
Comparison compare_with_golden(const GoldenPlace& place, const Scenario& scenario,
                               const RunSummary& summary) {
  if (is_there(place.txt_path) && read_digest_hash(place.txt_path) == hex(summary.state_hash) &&
      seals(read_text_file(place.txt_path), place.h5_path))
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
  if (has_golden_file(*place)) run.comparison = compare_with_golden(*place, scenario, run.summary);
  return run;
}

}  // namespace hyrax
