// The command study over the studies of sim/study.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <set>

#include "sim/study/study.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/study/study_command.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/program.h"
#include "tools/run_core/run_core.h"

namespace hyrax {
namespace {

std::int64_t steady_clock_ns() {
  using std::chrono::steady_clock;
  return std::chrono::duration_cast<std::chrono::nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

std::string processor_name() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown processor";
}

Result run_study(const Study& study, const StudyInput& input) {
  StudyRequest request{.core = input.core,
                       .is_quick = input.is_quick,
                       .within_px = input.within_px,
                       .core_step = program_step(input.core),
                       .machine = processor_name(),
                       .now_ns = steady_clock_ns,
                       .report_progress = input.report_progress};
  std::set<std::string> names;
  for (const std::string& path : input.scenarios) {
    request.scenarios.push_back({path, load_scenario(path)});
    const Scenario& scenario = request.scenarios.back().scenario;
    const Core core = run_core(input.core, path, scenario);
    if (study.needs_paper_step || core.constants)
      require_paper_core(core, path);
    else
      require_measurable(core, path, scenario);
    const std::string& name = scenario.name;
    if (!names.insert(name).second)
      refuse_input(path + ": /name: duplicate scenario name (found " + name +
                   "); scenarios of one study need different names");
  }
  const auto has_other_parameters = [&](const NamedScenario& named) {
    return named.scenario.parameters != request.scenarios.front().scenario.parameters;
  };
  if (!input.scenarios.empty() && std::ranges::none_of(request.scenarios, has_other_parameters))
    request.core = run_core(input.core, input.scenarios.front(), request.scenarios.front().scenario);
  try {
    return study.run(request);
  } catch (const RequestRefused& refused) {
    refuse_input(refused.what());
  }
}

}  // namespace

Command study_command() {
  std::vector<OfferedStudy> offered;
  for (const Study& study : studies())
    offered.push_back({study.name, study.summary, study.takes_scenarios, study.takes_within,
                       study.default_scenarios,
                       [&study](const StudyInput& input) { return run_study(study, input); },
                       [&study](const Core& core) {
                         if (study.needs_paper_step || core.constants)
                           require_paper_core(core, "hyrax-sim study " + study.name);
                       }});
  Command command = study_command_of(
      std::move(offered),
      {{"paper", "was removed; the paper's claims and their figures are in sim/physics/claims.md"},
       {"rest", "was removed; study frame-rate says where, when and how flings end at each rate"},
       {"bounces", "was removed; study hard-cases plays bounces without loss"}});
  command.summary = "measure error against cost, needs, hard cases, frame rates";
  command.example =
      "hyrax-sim study frame-rate --report frame-rate.html\n"
      "  hyrax-sim study needs scenarios/flings/first-fling.json --within 1px";
  command.is_common = true;
  return command;
}

}  // namespace hyrax
