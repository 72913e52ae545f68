#include "tools/app/check/check_verdict.h"

#include "sim/cause/watched_core.h"
#include "sim/replay/replay.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"
#include "tools/run_core/run_core.h"

namespace hyrax {
namespace {

void judge_into(const Core& own_core, const Scenario& scenario, const CheckOptions& options,
                CheckVerdict& verdict) {
  const Core core = run_core(own_core, verdict.path, scenario);
  require_measurable(core, verdict.path, scenario);
  if (options.draws) {
    RunPicture picture(scenario);
    static_cast<void>(replay(core, scenario, picture));
    verdict.picture = picture.panel(scenario);
  }
  verdict.golden = golden_place(verdict.path, options.golden_folder);
  const bool has_golden = verdict.has_golden = verdict.golden && has_golden_file(*verdict.golden);
  const Core watched_core =
      watched(core, {options.watched_step}, [&](const StepInput& input, std::span<TracedBody> bodies) {
        bodies.front().update(input);
        verdict.paths_taken.insert(bodies.front().path());
      });
  // Other constants may take other paths than the step that is watched.
  const Core& playing = options.watched_step && scenario.parameters.empty() ? watched_core : core;
  auto pair = has_golden ? compare_with_pair(core, scenario, *verdict.golden, options.reads_golden, playing)
                         : PairComparison{{.summary = play(playing, scenario)}};
  verdict.is_undecided = !pair;
  if (!pair) return;
  static_cast<PairComparison&>(verdict) = *std::move(pair);
  verdict.broken = broken_expectations(core, scenario, verdict.summary);
  if (!has_golden) verdict.state_hash = hex(verdict.summary.state_hash);
  if (std::string text = non_finite_text(scenario, verdict.summary.final); !text.empty())
    verdict.faults = {std::move(text)};
  verdict.is_non_finite = !verdict.faults.empty();
  if (verdict.differs()) {
    verdict.remark = verdict.comparison.physics;
    const bool is_known = verdict.runs != nullptr;
    verdict.is_repeated = !is_known || verdict.runs->is_repeated;
    if (!is_known) verdict.golden_fault = verdict.comparison.shape;
    if (!is_known || !verdict.runs->is_golden_as_blessed)
      verdict.to_restore = verdict.golden->h5_path + (is_known ? "" : " and " + verdict.golden->txt_path);
  }
  verdict.expects_hash = scenario.expect && scenario.expect->state_hash;
  if (!has_golden && !is_judged_by_hash(verdict.expects_hash, verdict.golden))
    verdict.status = CheckStatus::missing;
  else if (!verdict.comparison.agrees || !verdict.broken.empty() || !verdict.faults.empty())
    verdict.status = CheckStatus::disagreed;
}

// Empty for half a golden file, or one that cannot be read.
std::string stored_state_hash(const GoldenPlace& place) try {
  return is_regular_file(place.h5_path) && is_regular_file(place.txt_path)
             ? summary_state_hash(read_text_file(place.txt_path))
             : "";
} catch (const Failure&) {
  return "";
}

}  // namespace

CheckVerdict check_scenario(const Core& core, const std::string& path, const CheckOptions& options) {
  CheckVerdict verdict;
  verdict.path = path;
  judge_scenario(verdict, options.golden_folder, options.reads_golden,
                 [&] { judge_into(core, load_scenario(path), options, verdict); });
  return verdict;
}

CheckVerdict unreferenced_verdict(const UnreferencedGolden& golden) {
  CheckVerdict verdict;
  judge_unreferenced(verdict, golden);
  verdict.state_hash = stored_state_hash({golden.path + ".h5", golden.path + ".txt"});
  return verdict;
}

}  // namespace hyrax
