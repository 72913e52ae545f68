#include <cstdio>

#include "scenario_schema.h"
#include "tools/hyrax-sim/commands.h"

namespace hyrax {

Command schema_command() {
  return {.name = "schema",
          .summary = "print the JSON Schema of scenario files, for editors",
          .example = "hyrax-sim schema > scenario.schema.json",
          .declare = [](Options&) {
            return [] {
              std::fputs(kScenarioSchema, stdout);
              return ExitCode::agreed;
            };
          }};
}

}  // namespace hyrax
