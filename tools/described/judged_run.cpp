#include "tools/described/judged_run.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>

#include "tools/app/expect/judged_run.h"
#include "tools/described/run_text.h"
#include "tools/described/scenario_json.h"
#include "tools/files/path.h"

namespace hyrax {
namespace {

// Half a golden file is missing, too.
bool is_judged_by_hash(const DescribedRun& run) {
  const bool is_part_there = run.place && (is_there(run.place->h5_path) || is_there(run.place->txt_path));
  return !is_part_there && run.scenario.expect && run.scenario.expect->state_hash;
}

}  // namespace

std::vector<Expectation> DescribedRun::broken() const {
  std::vector<Expectation> broken;
  std::ranges::copy_if(expectations, std::back_inserter(broken), std::not_fn(&Expectation::holds));
  return broken;
}

bool DescribedRun::holds() const {
  return faults.empty() && std::ranges::all_of(expectations, &Expectation::holds) &&
         (!comparison || comparison->agrees());
}

std::string DescribedRun::sentence() const {
  if (!error.empty()) return error;
  std::string text;
  const auto add = [&](const std::string& more) {
    if (!more.empty()) text.append(text.empty() ? "" : "; ").append(more);
  };
  for (const std::string& fault : faults) add(fault);
  if (comparison && !comparison->agrees())
    add(comparison->fault.empty() ? comparison_sentence(*comparison) : comparison->fault);
  if (status == CheckStatus::missing) add(missing_golden_sentence(place));
  add(broken_sentence(broken()));
  return text;
}

DescribedRun judge_run(const DescribedCore& core, const std::string& path, const DescribedScenario& scenario,
                       const JudgeOptions& options) {
  DescribedRun run{.path = path, .scenario = scenario};
  run.place = path == "-" ? std::nullopt : golden_place(path, options.golden_folder);
  if (path == "-")
    run.not_compared = "standard input";
  else if (!run.place)
    run.not_compared = "no folder `scenarios` above it; --golden DIR names one";
  else if (!options.compares)
    run.not_compared = "values were set";
  run.has_golden = run.not_compared.empty() && has_golden_file(*run.place);
  run.contents = play_for_golden(core, scenario, options.also);
  run.faults = faults_of_run(core.description, run.contents.summary);
  if (auto fault = description_fault(core, scenario, kCheckedRowsMax, run.contents.summary.state_hash))
    run.faults.push_back(*std::move(fault));
  if (scenario.expect) run.expectations = judge(core.description, *scenario.expect, run.contents.summary);
  if (run.has_golden) run.comparison = compare_with_golden(core, scenario, run.contents, *run.place);
  if (!run.has_golden && !is_judged_by_hash(run))
    run.status = CheckStatus::missing;
  else if (!run.holds())
    run.status = CheckStatus::disagreed;
  run.exit_code = exit_code_of(run.status);
  return run;
}

DescribedRun judge_file(const DescribedCore& core, const std::string& path,
                        const std::string& golden_folder) {
  DescribedRun run{.path = path};
  const auto start = std::chrono::steady_clock::now();
  const auto failure = failure_of(path, [&] {
    if (path == "-") refuse_input("-: standard input has no golden file; name a scenario file");
    run = judge_run(core, path, load_described_scenario(core.description, path),
                    {.golden_folder = golden_folder});
  });
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!failure) return run;
  run.error = failure->what();
  run.status = CheckStatus::failed;
  run.exit_code = failure->exit_code();
  return run;
}

}  // namespace hyrax
