#include "tools/described/judged_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "tools/app/expect/judged_run.h"
#include "tools/app/library/check_flow.h"
#include "tools/described/scenario_json.h"

namespace hyrax {

Deviation DescribedRun::deviation() const {
  if (!comparison) return {};
  return {comparison->difference, comparison->max_px(), comparison->contacts, {}};
}

std::string DescribedRun::consequence() const {
  if (is_non_finite) return faults.front();
  return comparison ? comparison_sentence(*comparison) : "";
}

std::string DescribedRun::first_difference() const {
  if (!comparison || !comparison->first) return "";
  return fmt::format("step {}, field {}", comparison->first->step, comparison->first->value.name);
}

std::string DescribedRun::differences_text(bool) const {
  if (!comparison) return "";
  return comparison->fault.empty() ? comparison_text(*comparison) : "  " + comparison->fault + "\n";
}

Json::Object DescribedRun::differences_json() const {
  return comparison_json(comparison ? *comparison : GoldenComparison());
}

void DescribedRun::judge(const Description& description) {
  expects_hash = scenario.expect && scenario.expect->state_hash;
  expectations = scenario.expect ? hyrax::judge(description, *scenario.expect, contents.summary)
                                 : std::vector<Expectation>();
  broken.clear();
  std::ranges::copy_if(expectations, std::back_inserter(broken), std::not_fn(&Expectation::holds));
}

std::string DescribedRun::sentence() const {
  if (!error.empty()) return error;
  std::string text;
  const auto add = [&](const std::string& more) {
    if (!more.empty()) text.append(text.empty() ? "" : "; ").append(more);
  };
  for (const std::string& fault : faults) add(fault);
  if (differs()) add(comparison->fault.empty() ? comparison_sentence(*comparison) : comparison->fault);
  if (status == CheckStatus::missing) add(missing_golden_sentence(golden));
  add(broken_sentence(broken));
  return text;
}

void judge_run(const DescribedCore& core, DescribedRun& run, const JudgeOptions& options) {
  const DescribedScenario& scenario = run.scenario;
  run.golden = run.path == "-" ? std::nullopt : golden_place(run.path, options.golden_folder);
  if (run.path == "-")
    run.not_compared = "standard input";
  else if (!run.golden)
    run.not_compared = "no folder `scenarios` above it; --golden DIR names one";
  else if (!options.compares)
    run.not_compared = "values were set";
  run.has_golden = run.not_compared.empty() && has_golden_file(*run.golden);
  run.contents = play_for_golden(core, scenario, options.also);
  run.state_hash = run.contents.state_hash();
  run.faults = faults_of_run(core.description, run.contents.summary);
  run.is_non_finite = run.contents.summary.early_end && run.contents.summary.early_end->is_non_finite;
  if (auto fault = description_fault(core, scenario, kCheckedRowsMax, &run.contents.summary))
    run.faults.push_back(*std::move(fault));
  run.judge(core.description);
  run.is_undecided = run.has_golden && !options.reads_golden &&
                     !is_proved_to_agree(core, scenario, run.contents, *run.golden);
  if (run.is_undecided) return;
  if (run.has_golden) run.comparison = compare_with_golden(core, scenario, run.contents, *run.golden);
  if (run.differs()) run.golden_fault = run.comparison->fault;
  if (!run.golden_fault.empty()) run.to_restore = run.golden->h5_path + " and " + run.golden->txt_path;
  if (!run.has_golden && !is_judged_by_hash(run.expects_hash, run.golden))
    run.status = CheckStatus::missing;
  else if (!run.holds())
    run.status = CheckStatus::disagreed;
}

std::unique_ptr<FileRun> differing_golden(const DescribedCore& core, const DescribedRun& run) {
  if (!run.differs() || !run.golden_fault.empty()) return nullptr;
  return std::make_unique<FileRun>(core, run.golden->h5_path);
}

DescribedRun judge_file(const DescribedCore& core, const std::string& path, const JudgeOptions& options) {
  DescribedRun run;
  run.path = path;
  judge_scenario(run, options.golden_folder, options.reads_golden, [&] {
    run.scenario = load_described_scenario(core.description, path);
    if (!options.draws) return judge_run(core, run, options);
    DescribedPicture picture(core.description, run.scenario);
    JudgeOptions drawn = options;
    drawn.also.push_back(&picture);
    judge_run(core, run, drawn);
    run.picture = panel_picture(picture, picture_of(differing_golden(core, run)));
  });
  return run;
}

}  // namespace hyrax
