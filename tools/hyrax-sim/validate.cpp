#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/outcomes.h"
#include "tools/files/json.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

struct ValidateRequest {
  std::vector<std::string> files;
  Printing printing;
};

void print_good(const std::string& path, const Scenario& scenario, const Printing& printing) {
  if (printing.is_json || printing.is_quiet()) return;
  print_text("{}: {}, {}", path, VerdictWord{"good", true}, counted(step_count(scenario), "step"));
  if (printing.is_verbose())
    print_text(", {}, name {}", counted(scenario.events.size(), "event"), scenario.name);
  print_text("\n");
}

ExitCode validate(const ValidateRequest& request) {
  const std::vector<std::string> paths = list_scenarios(request.files);
  Outcomes outcomes;
  std::size_t good = 0;
  for (const std::string& path : paths)
    outcomes.attempt(path, [&] {
      print_good(path, load_scenario(path), request.printing);
      outcomes.add(Json::Object{{"scenario", path}, {"status", "good"}});
      ++good;
    });
  if (request.printing.is_json)
    print_json(outcomes.take_json("results"));
  else if (request.printing.is_quiet())
    print_text("{} of {} good\n", good, paths.size());
  return outcomes.exit_code();
}

void declare(Options& options, ValidateRequest& request) {
  options.files(request.files, {"SCENARIO", "", "scenario files, or folders of them; - for standard input"},
                1, -1);
  options.printing(request.printing, "print also the name and the number of events");
}

}  // namespace

Command validate_command() {
  return {.name = "validate",
          .summary = "check scenario files for errors, without playing them",
          .example = "hyrax-sim validate scenarios",
          .declare = with_request<ValidateRequest>(declare, validate)};
}

}  // namespace hyrax
