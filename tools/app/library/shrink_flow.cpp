#include "tools/app/library/shrink_flow.h"

#include <fmt/format.h>

#include "sim/result/number_text.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"
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

Json size_json(const ScenarioSize& size) {
  return Json::Object{{"steps", size.steps}, {"events", size.events}};
}

void print_shrunk(const ShrinkRequest& request, const SmallerScenario& smaller) {
  const auto& [before, after] = std::tie(smaller.before, smaller.after);
  if (request.printing.is_json)
    return print_json(Json::Object{{"scenario", request.files.front()},
                                   {"output", request.output},
                                   {"kept", smaller.kept},
                                   {"before", size_json(before)},
                                   {"after", size_json(after)},
                                   {"trials", smaller.trials},
                                   {"complete", smaller.is_complete}});
  print_text("written: {} ({} and {}, from {} and {})\n", request.output, counted(after.steps, "frame"),
             counted(after.events, "event"), before.steps, before.events);
  if (request.printing.is_quiet()) return;
  print_text("kept: {}\n", smaller.kept);
  print_text("{} tried{}\n", counted(smaller.trials, "scenario"),
             smaller.is_complete ? "" : ", until the limit; a smaller one may exist");
}

ExitCode shrink(const Core& core, const ShrinkRequest& request, const ShrinkScenario& find) {
  if (request.output.empty())
    refuse_input("hyrax-sim shrink: -o: is missing; name the file of the smaller scenario");
  OutputGuard(request.files)
      .admit_scenario("hyrax-sim shrink: -o", request.output, request.is_forced, {".json"});
  ShrinkLimits limits;
  limits.search_s = request.time_limit_s.value_or(limits.search_s);
  limits.run_s = request.run_limit_s.value_or(limits.run_s);
  const SmallerScenario smaller = find(core, request.files.front(), limits);
  write_text_file(request.output, smaller.text, request.is_forced);
  print_shrunk(request, smaller);
  return ExitCode::agreed;
}

void declare(Options& options, const std::string& said, ShrinkRequest& request) {
  options.files(request.files, {"SCENARIO", "", "a scenario of which `run` says " + said}, 1, 1);
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

std::string end_text(const WorkEnd& end, double limit_s) {
  if (end.is_timed_out()) return fmt::format("no end within {:g} s", limit_s);
  const std::string signal = end.signal_text();
  return signal.empty() ? "ends the program" : signal;
}

std::string shrunk_from(const std::string& name, std::int64_t steps, const std::string& kept) {
  return fmt::format("Shrunk from {}, {}; kept: {}.", name, plain_counted(steps, "frame"), kept);
}

Command shrink_command_of(const std::string& said, ShrinkScenario find) {
  const auto declare_it = [=](Options& options, ShrinkRequest& request) { declare(options, said, request); };
  const auto run = [find = std::move(find)](const Core& core, const ShrinkRequest& request) {
    return shrink(core, request, find);
  };
  return {.name = "shrink",
          .summary = "find the smallest scenario of which `run` says the same",
          .example = "hyrax-sim shrink my.json -o small.json",
          .declare = with_request<ShrinkRequest>(declare_it, run)};
}

}  // namespace hyrax
