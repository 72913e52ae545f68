#include "tools/app/command_line/scenario_commands.h"

#include "sim/result/number_text.h"
#include "tools/app/command_line/command_results.h"
#include "tools/app/command_line/print.h"
#include "tools/files/json.h"
#include "tools/files/scenario_list.h"

namespace hyrax {
namespace {

struct ValidateRequest {
  std::vector<std::string> files;
  Printing printing;
};

void print_good(const std::string& path, const GoodScenario& scenario, const Printing& printing) {
  if (printing.is_json || printing.is_quiet()) return;
  print_text("{}: {}, {}", path, VerdictWord{"good", true}, counted(scenario.steps, "step"));
  if (printing.is_verbose()) print_text(", {}, name {}", counted(scenario.events, "event"), scenario.name);
  print_text("\n");
}

ExitCode validate(const Core& core, const ValidateRequest& request, const ReadScenario& read) {
  const std::vector<std::string> paths = list_scenarios(request.files);
  CommandResults results;
  std::size_t good = 0;
  for (const std::string& path : paths)
    results.attempt(path, [&] {
      print_good(path, read(core, path), request.printing);
      results.add(Json::Object{{"scenario", path}, {"status", "good"}});
      ++good;
    });
  if (request.printing.is_json)
    print_json(results.take_json("results"));
  else if (request.printing.is_quiet())
    print_text("{} of {} good\n", good, paths.size());
  return results.exit_code();
}

void declare_validate(Options& options, ValidateRequest& request) {
  options.files(request.files, {"SCENARIO", "", "scenario files, or folders of them; - for standard input"},
                1, -1);
  options.printing(request.printing, "print also the name and the number of events");
}

}  // namespace

Command validate_command_of(ReadScenario read) {
  return {.name = "validate",
          .summary = "check scenario files for errors, without playing them",
          .example = "hyrax-sim validate scenarios",
          .declare = with_request<ValidateRequest>(declare_validate,
                                                   [read](const Core& core, const ValidateRequest& request) {
                                                     return validate(core, request, read);
                                                   })};
}

Command schema_command_of(std::function<std::string()> schema) {
  return {.name = "schema",
          .summary = "print the JSON Schema of scenario files, for editors",
          .example = "hyrax-sim schema > scenario.schema.json",
          .declare =
              with_request<Printing>([](Options& options, Printing& printing) { options.printing(printing); },
                                     [schema](const Printing&) {
                                       print_text("{}", schema());
                                       return ExitCode::agreed;
                                     })};
}

}  // namespace hyrax
