#include "tools/app/clock/new_scenario.h"

#include <algorithm>

#include "sim/result/number_text.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/files/json_pointer.h"
#include "tools/files/text_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

void set_clock(Json& document, const FrameTimes& frames) {
  const auto steps = static_cast<std::int64_t>(frames.dt_s.size());
  set_at(document, "/clock", Json::Object{{"dt_s", Json::Array(frames.dt_s.begin(), frames.dt_s.end())}});
  set_at(document, "/steps", steps);
  const auto* const events = document.get<Json::Array>("events");
  if (events != nullptr)
    set_at(document, "/events/0/step",
           std::min(static_cast<std::int64_t>(events->front().find("step")->number()), steps - 1));
}

}  // namespace

ExitCode write_new(const NewRequest& request, Json document,
                   const std::function<void(const Json&, const std::string& path)>& read) {
  std::optional<FrameTimes> frames;
  if (!request.clock.path.empty())
    frames = read_frame_times(request.clock);
  else if (request.clock != FrameTimesRequest{})
    refuse_input(
        "hyrax-sim new: --column, --unit, --application, --process and --swap-chain need --clock-from");
  const std::string path = request.names.front() + ".json";
  set_at(document, "/name", request.names.front());
  if (frames) set_clock(document, *frames);
  read(document, path);
  const auto steps = static_cast<std::int64_t>(document.find("steps")->number());
  std::vector<std::string> inputs;
  if (frames) inputs.push_back(request.clock.path);
  OutputGuard(inputs).admit_scenario("hyrax-sim new", path, request.is_forced);
  write_text_file(path, to_text(document, 1) + "\n", request.is_forced);
  if (frames && !frames->doubt.empty()) print_error(request.clock.path + ": " + frames->doubt);
  if (request.printing.is_json) {
    Json::Object written{{"scenario", path}, {"steps", steps}};
    if (frames && frames->dropped) written.emplace_back("dropped", *frames->dropped);
    if (frames && frames->left_out) written.emplace_back("left_out", *frames->left_out);
    print_json(written);
    return ExitCode::agreed;
  }
  print_text("written: {} ({})\n", path, counted(steps, "step"));
  if (frames && frames->dropped.value_or(0) > 0)
    print_text("{} of the {} frames were dropped: computed, but never on the display; they are steps too\n",
               *frames->dropped, steps);
  if (frames && frames->left_out.value_or(0) > 0)
    print_text("{} left out: FrameType is not Application, as of generated frames\n",
               counted(*frames->left_out, "row"));
  if (frames && frames->unit != "ms" && request.clock.unit.empty())
    print_text("frame times in {}, as the column fps says\n",
               frames->unit == "s" ? "seconds" : "microseconds");
  if (!request.printing.is_quiet())
    print_text("its $schema, for editors: {} > scenario.schema.json\n", program_command({"schema"}));
  return ExitCode::agreed;
}

void declare_new(Options& options, NewRequest& request, int least) {
  options.files(request.names, {"NAME", "", "the scenario's name; writes NAME.json in the current folder"},
                least, 1);
  FrameTimesRequest& clock = request.clock;
  options.text(clock.path,
               {"--clock-from", "FRAMES.csv",
                "a CSV file of recorded frame times, as from PresentMon, CapFrameX, OCAT or MangoHud"});
  options.text(clock.column,
               {"--column", "NAME",
                "the column of frame times (default: PresentMon's, MsBetweenPresents or FrameTime)"});
  options.choice(clock.unit,
                 {"--unit", "s|ms",
                  "the unit of frame times (default for PresentMon's: what a column fps says, else ms)"},
                 {"s", "ms"});
  options.text(clock.application, {"--application", "NAME", "take the frames of this application only"});
  options.text(clock.process, {"--process", "ID", "take those of this process"});
  options.text(clock.swap_chain, {"--swap-chain", "ADDRESS", "take those of this swap chain"});
  options.flag(request.is_forced, {"--force", "", "replace an existing NAME.json"});
  options.printing(request.printing);
}

}  // namespace hyrax
