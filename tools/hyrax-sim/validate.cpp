#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/scenario_commands.h"
#include "tools/files/scenario_reader.h"
#include "tools/run_core/run_core.h"

namespace hyrax {

Command validate_command() {
  return validate_command_of([](const Core& core, const std::string& path) {
    const Scenario scenario = load_scenario(path);
    static_cast<void>(run_core(core, path, scenario));
    return GoodScenario{scenario.name, step_count(scenario), scenario.events.size()};
  });
}

}  // namespace hyrax
