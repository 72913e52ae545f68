#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "sim/core/core.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/part.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/search/broken_rule.h"
#include "tools/files/json.h"
#include "tools/files/path.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct FuzzRequest {
  std::optional<std::uint64_t> seed;
  std::string time;
  std::optional<std::int64_t> runs;
  std::string against;
  std::string part;
  std::optional<std::int64_t> parts;
  std::string folder = ".";
  Printing printing;
};

// "90", "90s", "5m", "2h".
double parse_time_s(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  const double unit_s = unit.empty() || unit == "s" ? 1.0 : unit == "m" ? 60.0 : unit == "h" ? 3600.0 : 0.0;
  if (error != std::errc() || unit_s == 0.0 || !(value > 0.0) || !std::isfinite(value * unit_s))
    refuse_input("hyrax-sim fuzz: --time: must be a time above 0, as 60s, 5m or 2h (found " + text + ")");
  return value * unit_s;
}

FuzzLimits limits_of(const FuzzRequest& request) {
  if (!request.time.empty() && request.runs)
    refuse_input("hyrax-sim fuzz: --time and --runs: only one allowed");
  FuzzLimits limits;
  limits.seed = request.seed.value_or(1);
  limits.runs = request.runs;
  if (!request.time.empty()) limits.time_s = parse_time_s(request.time);
  limits.part = choose_part("hyrax-sim fuzz", request.part, request.parts).value_or(WorkPart{});
  return limits;
}

std::string shrunk_text(const Shrunk& shrunk) {
  if (!shrunk.fails_again) return "Not shrunk: it did not fail again.";
  return shrunk.is_complete ? "Shrunk." : "Shrunk as far as the limit of trials and time allowed.";
}

std::string description_of(const FuzzLimits& limits, const FuzzFailure& failure, const Shrunk& shrunk) {
  return fmt::format("Run {} of hyrax-sim fuzz --seed {}, {}: breaks {} ({}): {}. {}", failure.run,
                     limits.seed, plain_counted(step_count(failure.scenario), "frame"), failure.broken.name(),
                     failure.broken.rule(), failure.broken.found, shrunk_text(shrunk));
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
                      {"rule", failure.broken.name()},
                      {"found", failure.broken.found},
                      {"steps_before", step_count(failure.scenario)},
                      {"events_before", std::ssize(failure.scenario.events)},
                      {"scenario", path},
                      {"steps", step_count(shrunk.scenario)},
                      {"events", std::ssize(shrunk.scenario.events)},
                      {"trials", shrunk.trials},
                      {"fails_again", shrunk.fails_again}};
}

void print_json(const FuzzRequest& request, const FuzzLimits& limits, const FuzzOutcome& outcome,
                Json::Array failures) {
  print_json(Json::Object{{"seed", limits.seed},
                          {"part", Json::Object{{"index", limits.part.index}, {"count", limits.part.count}}},
                          {"against", request.against.empty() ? Json() : Json(request.against)},
                          {"runs", outcome.runs},
                          {"not_compared", outcome.not_compared},
                          {"elapsed_s", outcome.elapsed_s},
                          {"failures", std::move(failures)}},
             3);
}

// Commands that show the failure again.
std::string commands_for(const Core& core, const FuzzRequest& request, const std::string& written) {
  const std::string path = as_argument(written);
  if (request.against.empty() && !core.constants) return "  " + program_command({"run", path}) + "\n";
  if (request.against.empty())
    return "  " + program_command({"study", "hard-cases", path, "--gate", "--no-figures"}) + "\n";
  return "  " + program_command({"run", path, "-o", "here.h5"}) + "\n  " +
         shell_command({request.against, "run", path, "-o", "there.h5"}) + "\n  " +
         program_command({"diff", "here.h5", "there.h5"}) + "\n";
}

void print_outcome(const FuzzRequest& request, const FuzzLimits& limits, const FuzzOutcome& outcome) {
  if (request.printing.is_quiet()) return;
  print_text("seed {}: {} in {:.1f} s ({} per minute)\n", limits.seed, counted(outcome.runs, "run"),
             outcome.elapsed_s,
             with_decimals(static_cast<double>(outcome.runs) / outcome.elapsed_s * 60.0, 0));
}

void print_failure(const Core& core, const FuzzRequest& request, const FuzzFailure& failure,
                   const Shrunk& shrunk, const std::string& path) {
  const BrokenRule& broken = failure.broken;
  print_text("run {} {}: {} ({}): {}\n", failure.run,
             VerdictWord{broken.invariant ? "breaks an invariant" : "differs", false}, broken.name(),
             broken.rule(), broken.found);
  print_text("written: {} ({} and {}; found with {} and {})\n", path,
             plain_counted(step_count(shrunk.scenario), "frame"),
             plain_counted(shrunk.scenario.events.size(), "event"), step_count(failure.scenario),
             failure.scenario.events.size());
  if (!shrunk.fails_again)
    print_text("it did not fail again: what it does depends on more than the scenario\n");
  if (!request.printing.is_quiet()) print_text("{}", commands_for(core, request, path));
}

ExitCode run_fuzz(const Core& core, const FuzzRequest& request) {
  const FuzzLimits limits = limits_of(request);
  OutputGuard({}).admit("hyrax-sim fuzz: -o", (std::filesystem::path(request.folder) / "fuzz.json").string());
  std::optional<OtherProgram> other;
  const auto in_s = [](double time_s) {
    return OtherProgram::SteadyClock::now() +
           std::chrono::milliseconds(std::llround(1e3 * std::min(time_s, 1e9)));
  };
  constexpr double kLastBatch_s = 1.0;  // After the time is over.
  constexpr double kShrinking_s = 10.0;
  if (!request.against.empty()) {
    other.emplace(request.against, "hyrax-sim fuzz: --against",
                  limits.runs ? std::nullopt : std::optional(in_s(limits.time_s + kLastBatch_s)));
  }
  const OtherProgram* const against = other ? &*other : nullptr;
  const FuzzOutcome outcome = fuzz(core, limits, against);
  if (outcome.not_compared > 0)
    print_error(
        fmt::format("hyrax-sim fuzz: not compared: {}, which {} did not end in the time that was left",
                    counted(outcome.not_compared, "run"), request.against));
  if (other && !limits.runs) other->set_deadline(in_s(std::max(limits.time_s, kShrinking_s)));
  if (!request.printing.is_json) print_outcome(request, limits, outcome);
  Json::Array failures;
  if (outcome.failure) {
    const FuzzFailure& failure = *outcome.failure;
    Shrunk shrunk = shrink_broken(core, failure.scenario, failure.broken, against);
    const std::string path = write_failure(request, limits, failure, shrunk);
    failures.push_back(failure_json(failure, shrunk, path));
    if (!request.printing.is_json) print_failure(core, request, failure, shrunk, path);
  } else if (!request.printing.is_json) {
    print_text("{}\n", VerdictWord{outcome.runs == 0         ? "nothing was tested"
                                   : request.against.empty() ? "all invariants hold"
                                   : outcome.not_compared == 0
                                       ? "all invariants hold, all state hashes agree"
                                       : "all invariants hold, the state hashes that were compared agree",
                                   outcome.runs > 0});
  }
  if (request.printing.is_json) print_json(request, limits, outcome, std::move(failures));
  return outcome.failure ? ExitCode::disagreed : ExitCode::agreed;
}

void declare(Options& options, FuzzRequest& request) {
  options.seed(request.seed, {"--seed", "N", "which scenarios are drawn (default: 1)"});
  options.text(request.time, {"--time", "TIME", "how long, as 60s, 5m or 2h (default: 60s)"});
  options.integer(request.runs, {"--runs", "N", "how many scenarios, instead of a time"}, 1);
  options.text(
      request.against,
      {"--against", "PROGRAM",
       "also compare state hashes with another hyrax-sim, which plays many scenarios in one process (some "
       "0.2 ms each with TMPDIR in memory, 0.7 ms on a disk; more if its `check --json` prints no hashes)"});
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
              "  hyrax-sim fuzz --runs 100000 --seed 7 --against ./other-build/hyrax-sim -o failures",
          .declare = with_request<FuzzRequest>(declare, run_fuzz)};
}

}  // namespace hyrax
