#include <memory>

#include "scenario_schema.h"
#include "tools/app/command_line/options.h"

namespace hyrax {

Command schema_command() {
  return {.name = "schema",
          .summary = "print the JSON Schema of scenario files, for editors",
          .example = "hyrax-sim schema > scenario.schema.json",
          .declare = [](Options& options) {
            const auto printing = std::make_shared<Printing>();
            options.printing(*printing);
            return [printing] {
              print_text(kScenarioSchema);
              return ExitCode::agreed;
            };
          }};
}

}  // namespace hyrax
