#include "new_core.h"
#include "tools/app/clock/new_scenario.h"
#include "tools/files/build_info.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

constexpr std::string_view kTemplate = R"({
  "$schema": "scenario.schema.json",
  "format": "hyrax-scenario/1",
  "name": "",
  "description": "What happens, and why it is worth testing.",
  "window": { "width_px": 1920, "height_px": 1080 },
  "sprite": { "width_px": 128, "height_px": 128 },
  "start": { "x_px": 300, "y_px": 500, "vx_px_per_s": 900, "vy_px_per_s": -700 },
  "clock": { "rate_hz": 60 },
  "steps": 600,
  "events": [ { "step": 120, "fling": { "vx_px_per_s": -1500, "vy_px_per_s": -900 } } ],
  "record": { "every": 1 },
  "expect": { "in_bounds": true, "finite": true }
})";

// A core that describes itself, and how to add it to a project.
ExitCode write_core(const NewRequest& request) {
  if (!request.names.empty() || request.clock != FrameTimesRequest{})
    refuse_input("hyrax-sim new: --core writes a header; NAME and a clock are those of a scenario");
  OutputGuard({}).admit_scenario("hyrax-sim new: --core", request.core, request.is_forced, {".h", ".hpp"});
  write_text_file(request.core, kNewCore, request.is_forced);
  const std::string stem(file_name(request.core).stem);
  const std::string name = stem.ends_with("_core") ? stem.substr(0, stem.size() - 5) : stem;
  const std::string_view version = build_info().version;
  if (request.printing.is_json)
    print_json(Json::Object{{"core", request.core}});
  else
    print_text(
        "written: {}; in its folder, the lines for CMakeLists.txt:\n\n"
        "find_package(hyrax {} REQUIRED)\n"
        "hyrax_add_scenarios(scenarios CORE {}{})\n\n"
        "They build {}-sim: `{}-sim new first` writes a scenario.\n",
        request.core, version.substr(0, version.rfind('.')), stem, file_name(request.core).extension, name,
        name);
  return ExitCode::agreed;
}

ExitCode write_scenario(const NewRequest& request) {
  if (!request.core.empty()) return write_core(request);
  if (request.names.empty()) refuse_usage("hyrax-sim new", "NAME: at least 1 needed (found 0)");
  return write_new(request, parse_json(kTemplate, "new"), [](const Json& document, const std::string& path) {
    static_cast<void>(to_scenario(document, path, ""));
  });
}

void declare(Options& options, NewRequest& request) {
  options.text(
      request.core,
      {"--core", "HEADER", "write a core that describes itself instead, with every list that it may have"});
  declare_new(options, request, 0);
}

}  // namespace

Command new_command() {
  return {.name = "new",
          .summary = "write a scenario file to start from, with every common key",
          .example = "hyrax-sim new my-fling --clock-from presentmon.csv",
          .needs_strict_ieee = false,
          .declare = with_request<NewRequest>(declare, write_scenario)};
}

}  // namespace hyrax
