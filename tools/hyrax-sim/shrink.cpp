#include <fmt/format.h>

#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/options.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/search/shrink_run.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct ShrinkRequest {
  std::vector<std::string> files;
  std::string output;
  std::optional<double> time_limit_s;
  std::optional<double> run_limit_s;
  bool is_forced = false;
  Printing printing;
};

Json size_json(const Scenario& scenario) {
  return Json::Object{{"steps", step_count(scenario)},
                      {"events", static_cast<std::int64_t>(scenario.events.size())}};
}

void print_shrunk(const ShrinkRequest& request, const Scenario& before, const ShrunkRun& run) {
  const Scenario& after = run.shrunk.scenario;
  if (request.printing.is_json)
    return print_json(Json::Object{{"scenario", request.files.front()},
                                   {"output", request.output},
                                   {"kept", run.kept},
                                   {"before", size_json(before)},
                                   {"after", size_json(after)},
                                   {"trials", run.shrunk.trials},
                                   {"complete", run.shrunk.is_complete}});
  print_text("written: {} ({} and {}, from {} and {})\n", request.output, counted(step_count(after), "frame"),
             counted(after.events.size(), "event"), step_count(before), before.events.size());
  if (request.printing.is_quiet()) return;
  print_text("kept: {}\n", run.kept);
  print_text("{} tried{}\n", counted(run.shrunk.trials, "scenario"),
             run.shrunk.is_complete ? "" : ", until the limit; a smaller one may exist");
}

ExitCode run_shrink(const Core& core, const ShrinkRequest& request) {
  const std::string& path = request.files.front();
  if (request.output.empty())
    refuse_input("hyrax-sim shrink: -o: is missing; name the file of the smaller scenario");
  OutputGuard(request.files)
      .admit_scenario("hyrax-sim shrink: -o", request.output, request.is_forced, {".json"});
  const Scenario scenario = load_scenario(path);
  require_measurable(core, path, scenario);
  RunLimits limits;
  limits.search_s = request.time_limit_s.value_or(limits.search_s);
  limits.run_s = request.run_limit_s.value_or(limits.run_s);
  ShrunkRun run = shrink_run(core, path, scenario, limits);
  if (!run.shrunk.fails_again)
    refuse_input(path + ": did not say it again (" + run.kept + "); only what every run says can be kept");
  run.shrunk.scenario.description = fmt::format("Shrunk from {}, {}; kept: {}.", scenario.name,
                                                plain_counted(step_count(scenario), "frame"), run.kept);
  write_text_file(request.output, scenario_file_text(run.shrunk.scenario), request.is_forced);
  print_shrunk(request, scenario, run);
  return ExitCode::agreed;
}

void declare(Options& options, ShrinkRequest& request) {
  options.files(request.files,
                {"SCENARIO", "",
                 "a scenario of which `run` says that it breaks a rule of `expect` or an invariant, or "
                 "that it is not finite; that ends the program, or does not end; or to which the "
                 "accepted core gives other bits"},
                1, 1);
  options.text(request.output,
               {"-o,--output", "SMALL.json", "the smallest scenario of which it says the same"});
  options.time(request.time_limit_s,
               {"--time-limit", "TIME", "how long to search, as 60s, 5m or 2h (default: 60s)"});
  options.time(request.run_limit_s,
               {"--run-limit", "TIME", "a run that takes longer does not end (default: 10s)"});
  options.flag(request.is_forced, {"--force", "", "replace an existing SMALL.json"});
  for (const char* const name : {"--fails", "--against"})
    options.removed(name, "`hyrax-sim shrink SCENARIO -o SMALL.json` keeps what `run` says of SCENARIO");
  options.printing(request.printing);
}

}  // namespace

Command shrink_command() {
  return {.name = "shrink",
          .summary = "find the smallest scenario of which `run` says the same",
          .example = "hyrax-sim shrink my.json -o small.json",
          .declare = with_request<ShrinkRequest>(declare, run_shrink)};
}

}  // namespace hyrax
