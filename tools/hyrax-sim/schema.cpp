#include <memory>

#include "scenario_schema.h"
#include "tools/files/printable.h"
#include "tools/hyrax-sim/commands.h"

namespace hyrax {

Command schema_command() {
  return {.name = "schema",
          .summary = "print the JSON Schema of scenario files, for editors",
          .example = "hyrax-sim schema > scenario.schema.json",
          .declare = [](Options& options) {
            const auto is_json = std::make_shared<bool>(false);
            options.flag(*is_json, {"--json", "", "changes nothing: the schema is one JSON document"});
            return [is_json] {
              print_text(kScenarioSchema);
              return ExitCode::agreed;
            };
          }};
}

}  // namespace hyrax
