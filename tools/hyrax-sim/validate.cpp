#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/scenario_commands.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {

Command validate_command() {
  return validate_command_of([](const std::string& path) {
    const Scenario scenario = load_scenario(path);
    return GoodScenario{scenario.name, step_count(scenario), scenario.events.size()};
  });
}

}  // namespace hyrax
