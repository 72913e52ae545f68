#include "scenario_schema.h"
#include "tools/app/command_line/scenario_commands.h"

namespace hyrax {

Command schema_command() {
  return schema_command_of([] { return std::string(kScenarioSchema); });
}

}  // namespace hyrax
