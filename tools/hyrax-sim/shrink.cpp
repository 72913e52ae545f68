#include "sim/scenario/frame_clock.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/library/shrink_flow.h"
#include "tools/app/search/shrink_run.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/run_core/run_core.h"

namespace hyrax {
namespace {

ScenarioSize size_of(const Scenario& scenario) { return {step_count(scenario), std::ssize(scenario.events)}; }

SmallerScenario find_smaller(const Core& own_core, const std::string& path, const ShrinkLimits& limits) {
  const Scenario scenario = load_scenario(path);
  const Core core = run_core(own_core, path, scenario);
  require_measurable(core, path, scenario);
  ShrunkRun run = shrink_run(core, path, scenario, limits);
  if (!run.shrunk.fails_again)
    refuse_input(path + ": did not say it again (" + run.kept + "); only what every run says can be kept");
  Scenario& smaller = run.shrunk.scenario;
  smaller.description = shrunk_from(scenario.name, step_count(scenario), run.kept);
  return {.kept = run.kept,
          .text = scenario_file_text(smaller),
          .before = size_of(scenario),
          .after = size_of(smaller),
          .trials = run.shrunk.trials,
          .is_complete = run.shrunk.is_complete};
}

}  // namespace

Command shrink_command() {
  return shrink_command_of(
      "that it breaks a rule of `expect` or an invariant, or that it is not finite; that ends the program, "
      "or "
      "does not end; or to which the accepted core gives other bits",
      find_smaller);
}

}  // namespace hyrax
