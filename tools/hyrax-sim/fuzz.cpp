#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "sim/core/core.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/part.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/search/fuzz.h"
#include "tools/app/search/shrink_run.h"
#include "tools/files/json.h"
#include "tools/files/path.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct FuzzRequest {
  std::optional<std::uint64_t> seed;
  std::optional<double> time_s;
  std::optional<std::int64_t> runs;
  std::vector<std::string> without;
  std::string part;
  std::optional<std::int64_t> parts;
  std::string folder = ".";
  Printing printing;
};

FuzzLimits limits_of(const FuzzRequest& request) {
  if (request.time_s && request.runs) refuse_input("hyrax-sim fuzz: --time and --runs: only one allowed");
  FuzzLimits limits;
  limits.seed = request.seed.value_or(limits.seed);
  limits.runs = request.runs;
  limits.without = request.without;
  limits.time_s = request.time_s.value_or(limits.time_s);
  limits.part = choose_part("hyrax-sim fuzz", request.part, request.parts).value_or(WorkPart{});
  return limits;
}

std::string shrunk_text(const Shrunk& shrunk) {
  if (!shrunk.fails_again) return "Not shrunk: it did not fail again.";
  return shrunk.is_complete ? "Shrunk." : "Shrunk as far as the limit of trials allowed.";
}

std::string description_of(const FuzzLimits& limits, const FuzzFailure& failure, const Shrunk& shrunk) {
  return fmt::format("Run {} of hyrax-sim fuzz --seed {}, {}: breaks {} ({}): {}. {}", failure.run,
                     limits.seed, plain_counted(step_count(failure.scenario), "frame"),
                     text_of(failure.broken).name, text_of(failure.broken).rule, failure.found,
                     shrunk_text(shrunk));
}

// Names the scenario, and returns the path of its file. A file of that name is kept: the scenario gets a
// number.
std::string write_failure(const FuzzRequest& request, const FuzzLimits& limits, const FuzzFailure& failure,
                          Shrunk& shrunk) {
  make_folder(request.folder);
  Scenario& scenario = shrunk.scenario;
  std::string path;
  for (int number = 1; path.empty() || is_there(path); ++number) {
    scenario.name = failure.scenario.name + (number == 1 ? "" : fmt::format("-{}", number));
    path = (std::filesystem::path(request.folder) / (scenario.name + ".json")).string();
    if (request.folder == ".") path = scenario.name + ".json";
  }
  scenario.description = description_of(limits, failure, shrunk);
  write_text_file(path, scenario_file_text(scenario));
  return path;
}

Json failure_json(const FuzzFailure& failure, const Shrunk& shrunk, const std::string& path) {
  return Json::Object{{"run", failure.run},
                      {"rule", text_of(failure.broken).name},
                      {"found", failure.found},
                      {"steps_before", step_count(failure.scenario)},
                      {"events_before", std::ssize(failure.scenario.events)},
                      {"scenario", path},
                      {"steps", step_count(shrunk.scenario)},
                      {"events", std::ssize(shrunk.scenario.events)},
                      {"trials", shrunk.trials},
                      {"fails_again", shrunk.fails_again}};
}

void print_json(const FuzzLimits& limits, const FuzzOutcome& outcome, Json::Array failures) {
  print_json(Json::Object{{"seed", limits.seed},
                          {"part", Json::Object{{"index", limits.part.index}, {"count", limits.part.count}}},
                          {"without", list_of(limits.without, [](const std::string& rule) { return rule; })},
                          {"runs", outcome.runs},
                          {"elapsed_s", outcome.elapsed_s},
                          {"failures", std::move(failures)}},
             3);
}

// Shows the failure again.
std::string command_for(const Core& core, const std::string& written) {
  const std::string path = as_argument(written);
  return program_command(core.constants
                             ? std::vector<std::string>{"study", "hard-cases", path, "--gate", "--no-figures"}
                             : std::vector<std::string>{"run", path});
}

void print_outcome(const FuzzOutcome& outcome) {
  print_text("{} in {:.1f} s ({} per minute)\n", counted(outcome.runs, "run"), outcome.elapsed_s,
             with_decimals(static_cast<double>(outcome.runs) / outcome.elapsed_s * 60.0, 0));
}

void print_failure(const Core& core, const FuzzRequest& request, const FuzzFailure& failure,
                   const Shrunk& shrunk, const std::string& path) {
  const InvariantText& broken = text_of(failure.broken);
  print_text("run {} {}: {} ({}): {}\n", failure.run, VerdictWord{"breaks an invariant", false}, broken.name,
             broken.rule, failure.found);
  print_text("written: {} ({} and {}; found with {} and {})\n", path,
             plain_counted(step_count(shrunk.scenario), "frame"),
             plain_counted(shrunk.scenario.events.size(), "event"), step_count(failure.scenario),
             failure.scenario.events.size());
  if (!shrunk.fails_again)
    print_text("it did not fail again: what it does depends on more than the scenario\n");
  if (!request.printing.is_quiet()) print_text("  {}\n", command_for(core, path));
}

ExitCode run_fuzz(const Core& core, const FuzzRequest& request) {
  const FuzzLimits limits = limits_of(request);
  OutputGuard({}).admit("hyrax-sim fuzz: -o", (std::filesystem::path(request.folder) / "fuzz.json").string());
  const bool tells_runs = !request.printing.is_json && !request.printing.is_quiet();
  if (tells_runs) {
    print_text("seed {}\n", limits.seed);
    std::fflush(stdout);  // A core that crashes ends the program: by its seed the run is played again.
  }
  const FuzzOutcome outcome = fuzz(core, limits);
  if (tells_runs) print_outcome(outcome);
  Json::Array failures;
  if (outcome.failure) {
    const FuzzFailure& failure = *outcome.failure;
    Shrunk shrunk = shrink_broken(core, failure.scenario, failure.broken);
    const std::string path = write_failure(request, limits, failure, shrunk);
    failures.push_back(failure_json(failure, shrunk, path));
    if (!request.printing.is_json) print_failure(core, request, failure, shrunk, path);
  } else if (!request.printing.is_json) {
    print_text("{}\n", VerdictWord{outcome.runs == 0        ? "nothing was tested"
                                   : limits.without.empty() ? "all invariants hold"
                                                            : "the other invariants hold",
                                   outcome.runs > 0});
  }
  if (request.printing.is_json) print_json(limits, outcome, std::move(failures));
  return outcome.failure ? ExitCode::disagreed : ExitCode::agreed;
}

void declare(Options& options, FuzzRequest& request) {
  options.seed(request.seed, {"--seed", "N", "which scenarios are drawn (default: 1)"});
  options.time(request.time_s, {"--time", "TIME", "how long, as 60s, 5m or 2h (default: 60s)"});
  options.integer(request.runs, {"--runs", "N", "how many scenarios, instead of a time"}, 1);
  options.choices(request.without,
                  {"--without", "RULE", "an invariant that a run may break; may be repeated"}, fuzzed_rules(),
                  "rule");
  options.removed("--against",
                  "`hyrax-sim check --core` judges another core, hyrax-replay compares platforms");
  options.text(request.part, {"--part", "I/N",
                              "play only the runs k with k mod N = I, 0 <= I < N (default: as SLURM or Open "
                              "MPI says in the environment, else all)"});
  options.integer(request.parts, {"--parts", "N", "the same, with I from JOB_COMPLETION_INDEX"}, 1);
  options.text(
      request.folder,
      {"-o,--output", "DIR",
       "folder for a failing scenario, shrunk, named fuzz-SEED-RUN.json (default: the current one)"});
  options.printing(request.printing);
}

}  // namespace

Command fuzz_command() {
  return {.name = "fuzz",
          .summary = "play random scenarios and check what must hold in every run",
          .example =
              "hyrax-sim fuzz --time 60s\n"
              "  hyrax-sim fuzz --runs 100000 --seed 7 --without in-bounds -o failures",
          .declare = with_request<FuzzRequest>(declare, run_fuzz)};
}

}  // namespace hyrax
