// The command study of a core that describes itself, and its frame-rate.

#include "sim/described/described_ladder.h"
#include "sim/study/frame_rate/ladder_result.h"
#include "tools/app/study/study_command.h"
#include "tools/described/commands.h"
#include "tools/described/run_text.h"
#include "tools/described/scenario_json.h"
#include "tools/files/failure.h"

namespace hyrax {
namespace {

std::vector<DescribedScenario> scenarios_of(const Description& description, const StudyInput& input) {
  if (input.scenarios.empty()) return library_or_defaults(description);
  std::vector<DescribedScenario> scenarios;
  for (const std::string& path : input.scenarios)
    scenarios.push_back(load_described_scenario(description, path));
  return scenarios;
}

Result study_frame_rate(const DescribedCore& core, const StudyInput& input) {
  if (!has_px(core.description))
    refuse_input("hyrax-sim study frame-rate: no value of the core " + core.description.core +
                 " is in px; a name that ends in _px has this unit");
  std::vector<double> rates_hz(kLandingRates_hz.begin(), kLandingRates_hz.end());
  if (input.is_quick) rates_hz = {24.0, 60.0, 144.0, 240.0};
  std::vector<RateLadder> ladders;
  std::vector<std::string> left_out;
  const std::vector<DescribedScenario> scenarios = scenarios_of(core.description, input);
  for (const DescribedScenario& scenario : scenarios) {
    std::string why = why_one_rate(scenario);
    if (why.empty()) {
      ladders.push_back(climb(core, scenario, rates_hz, [&](const DescribedSummary& run) {
        return faults_of_run(core.description, run);
      }));
      if (ladders.back().until_s == 0.0) {
        ladders.pop_back();
        why = "no time passes in it";
      }
    }
    if (!why.empty()) left_out.push_back(scenario.name + ": left out, as " + why + ".");
    input.report_progress("scenarios", std::ssize(ladders) + std::ssize(left_out), std::ssize(scenarios));
  }
  if (ladders.empty()) refuse_input("hyrax-sim study frame-rate: " + left_out.front());
  return ladder_result(ladders, left_out);
}

}  // namespace

Command described_study_command(const DescribedCore& core) {
  const std::string needs =
      "needs the paper's step; " + core.description.core + " describes itself: use study frame-rate, diff";
  Command command =
      study_command_of({{.name = "frame-rate",
                         .summary = "how far each frame rate is from the finest, and whether it converges",
                         .run = [&core](const StudyInput& input) { return study_frame_rate(core, input); }},
                        {.name = "hard-cases",
                         .summary = "what must hold in every run, however hard the scenario",
                         .run =
                             [&core](const StudyInput& input) {
                               return study_hard_cases(core, scenarios_of(core.description, input), input);
                             }}},
                       {{"speed-error", needs}, {"needs", needs}});
  command.summary = "compare frame rates, play hard cases";
  command.example = "hyrax-sim study frame-rate --report frame-rate.html";
  return command;
}

}  // namespace hyrax
