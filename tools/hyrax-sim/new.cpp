#include <algorithm>
#include <optional>

#include "sim/result/number_text.h"
#include "tools/app/clock/frame_times.h"
#include "tools/app/command_line/options.h"
#include "tools/files/json_pointer.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

constexpr std::int64_t kFlingStep = 120;
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

struct NewRequest {
  std::vector<std::string> names;
  FrameTimesRequest clock;
  bool is_forced = false;
  Printing printing;
};

Json new_document(const NewRequest& request, const std::optional<FrameTimes>& frames) {
  Json document = parse_json(kTemplate, "new");
  set_at(document, "/name", request.names.front());
  if (!frames) return document;
  const auto steps = static_cast<std::int64_t>(frames->dt_s.size());
  set_at(document, "/clock", Json::Object{{"dt_s", Json::Array(frames->dt_s.begin(), frames->dt_s.end())}});
  set_at(document, "/steps", steps);
  set_at(document, "/events/0/step", std::min(kFlingStep, steps - 1));
  return document;
}

ExitCode write_new(const NewRequest& request) {
  std::optional<FrameTimes> frames;
  if (!request.clock.path.empty())
    frames = read_frame_times(request.clock);
  else if (request.clock != FrameTimesRequest{})
    refuse_input(
        "hyrax-sim new: --column, --unit, --application, --process and --swap-chain need --clock-from");
  const std::string path = request.names.front() + ".json";
  const Json document = new_document(request, frames);
  const std::int64_t steps = std::get<std::int64_t>(to_scenario(document, path, "").length);
  std::vector<std::string> inputs;
  if (frames) inputs.push_back(request.clock.path);
  OutputGuard(inputs).admit_scenario("hyrax-sim new", path, request.is_forced);
  write_text_file(path, to_text(document, 1) + "\n", request.is_forced);
  if (request.printing.is_json) {
    Json::Object written{{"scenario", path}, {"steps", steps}};
    if (frames && frames->dropped) written.emplace_back("dropped", *frames->dropped);
    print_json(written);
    return ExitCode::agreed;
  }
  print_text("written: {} ({})\n", path, counted(steps, "step"));
  if (frames && frames->dropped.value_or(0) > 0)
    print_text("{} of the {} frames were dropped: computed, but never on the display; they are steps too\n",
               *frames->dropped, steps);
  if (!request.printing.is_quiet())
    print_text("its $schema, for editors: hyrax-sim schema > scenario.schema.json\n");
  return ExitCode::agreed;
}

void declare(Options& options, NewRequest& request) {
  options.files(request.names, {"NAME", "", "the scenario's name; writes NAME.json in the current folder"}, 1,
                1);
  FrameTimesRequest& clock = request.clock;
  options.text(clock.path,
               {"--clock-from", "FRAMES.csv", "a CSV file of recorded frame times, as from PresentMon"});
  options.text(clock.column,
               {"--column", "NAME",
                "the column of frame times (default: PresentMon's, MsBetweenPresents or FrameTime)"});
  options.choice(clock.unit, {"--unit", "s|ms", "the unit of frame times (default for PresentMon's: ms)"},
                 {"s", "ms"});
  options.text(clock.application, {"--application", "NAME", "take the frames of this application only"});
  options.text(clock.process, {"--process", "ID", "take those of this process"});
  options.text(clock.swap_chain, {"--swap-chain", "ADDRESS", "take those of this swap chain"});
  options.flag(request.is_forced, {"--force", "", "replace an existing NAME.json"});
  options.printing(request.printing);
}

}  // namespace

Command new_command() {
  return {.name = "new",
          .summary = "write a scenario file to start from, with every common key",
          .example = "hyrax-sim new my-fling --clock-from presentmon.csv",
          .needs_strict_ieee = false,
          .declare = with_request<NewRequest>(declare, write_new)};
}

}  // namespace hyrax
