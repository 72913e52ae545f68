#include "scenario_schema.h"
#include "tools/app/command_line/options.h"

namespace hyrax {

Command schema_command() {
  return {.name = "schema",
          .summary = "print the JSON Schema of scenario files, for editors",
          .example = "hyrax-sim schema > scenario.schema.json",
          .declare =
              with_request<Printing>([](Options& options, Printing& printing) { options.printing(printing); },
                                     [](const Printing&) {
                                       print_text(kScenarioSchema);
                                       return ExitCode::agreed;
                                     })};
}

}  // namespace hyrax
