#include "sim/scenario/frame_clock.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/hyrax-sim/command_line/print.h"
#include "tools/hyrax-sim/commands/commands.h"

namespace hyrax {
namespace {

struct ValidateRequest {
  std::vector<std::string> files;
  bool is_json = false;
};

ExitCode validate(const ValidateRequest& request) {
  ExitCode exit_code = ExitCode::agreed;
  Json::Array results;
  for (const std::string& path : list_scenarios(request.files)) {
    try {
      const Scenario scenario =
          path == "-" ? parse_scenario(read_text_file("/dev/stdin"), path) : load_scenario(path);
      if (!request.is_json) print_text("{}: good, {} steps\n", path, step_count(scenario));
      results.push_back(Json::Object{{"scenario", path}, {"status", "good"}});
    } catch (const Failure& failure) {
      print_error(failure.what());
      exit_code = more_serious(exit_code, failure.exit_code());
      results.push_back(Json::Object{{"scenario", path}, {"status", "failed"}, {"error", failure.what()}});
    }
  }
  if (request.is_json)
    print_text("{}\n", to_text(Json::Object{{"results", std::move(results)}}, {.depth_indented = 2}));
  return exit_code;
}

}  // namespace

Command validate_command() {
  return {.name = "validate",
          .summary = "check scenario files for errors, without playing them",
          .example = "hyrax-sim validate scenarios",
          .declare = [](Options& options) {
            const auto request = std::make_shared<ValidateRequest>();
            options.files(request->files,
                          {"SCENARIO", "", "scenario files, or folders of them; - is standard input"}, 1, -1);
            options.flag(request->is_json, {"--json", "", "one JSON document instead of the table"});
            return [request] { return validate(*request); };
          }};
}

}  // namespace hyrax
