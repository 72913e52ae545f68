#include <optional>
#include <utility>

#include "sim/core/core.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "sim/search/random_scenario.h"
#include "sim/search/run_check.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/core/controlled_core.h"
#include "tools/app/library/fuzz_flow.h"
#include "tools/app/search/shrink_run.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

struct FuzzFailure {
  Scenario scenario;
  std::optional<Invariant> broken;  // Nothing: the core throws.
  std::string found;                // "-3 px at step 4"; what it throws.
  std::string thrown;               // CoreFailure::without_row.
};

constexpr InvariantText kThrows = {"throws", "the core throws nothing", ""};
const InvariantText& text_of(const FuzzFailure& failure) {
  return failure.broken ? text_of(*failure.broken) : kThrows;
}

// The names of the invariants that a random scenario can break.
std::vector<std::string> fuzzed_rules() {
  std::vector<std::string> rules;
  for (std::size_t index = 0; index < static_cast<std::size_t>(Invariant::comes_to_rest); ++index)
    if (static_cast<Invariant>(index) != Invariant::no_time) rules.emplace_back(kInvariantTexts[index].name);
  return rules;
}

std::optional<FuzzFailure> play(const Core& core, const FuzzRequest& request, std::uint64_t number) {
  RandomRun random = random_run(core, request.first_seed(), number);
  CheckedRun run;
  try {
    run = check_run(core, random.scenario, random.stops);
  } catch (const CoreFailure& failure) {
    if (failure.exit_code() != ExitCode::disagreed) throw;
    return FuzzFailure{std::move(random.scenario), {}, failure.what(), failure.without_row()};
  }
  for (const Invariant broken : broken_invariants(random.scenario, run.measures))
    if (!request.allows(text_of(broken).name)) {
      const InvariantMeasure& measure = run.measures[static_cast<std::size_t>(broken)];
      return FuzzFailure{
          std::move(random.scenario), broken,
          fmt::format("{:.3g} {} at step {}", measure.slack, text_of(broken).unit, measure.worst_step), ""};
    }
  return std::nullopt;
}

std::string shrunk_text(const Shrunk& shrunk) {
  if (!shrunk.fails_again) return "Not shrunk: it did not fail again.";
  return shrunk.is_complete ? "Shrunk." : "Shrunk as far as the limit of trials allowed.";
}

// Names the scenario, and returns the path of its file.
std::string write_failure(const FuzzRequest& request, std::uint64_t run, const FuzzFailure& failure,
                          Shrunk& shrunk) {
  Scenario& scenario = shrunk.scenario;
  scenario.name = failure.scenario.name;
  const std::string path = failure_path(request, scenario.name);
  scenario.description =
      fmt::format("Run {} of hyrax-sim fuzz --seed {}, {}: breaks {} ({}): {}. {}", run, request.first_seed(),
                  plain_counted(step_count(failure.scenario), "frame"), text_of(failure).name,
                  text_of(failure).rule, failure.found, shrunk_text(shrunk));
  write_text_file(path, scenario_file_text(scenario));
  return path;
}

FuzzFinding find(const Core& core, const FuzzRequest& request, std::uint64_t run,
                 const FuzzFailure& failure) {
  const InvariantText& broken = text_of(failure);
  Shrunk shrunk = shrink_broken(core, failure.scenario, failure.broken, failure.thrown);
  const std::string path = write_failure(request, run, failure, shrunk);
  return {
      .sentence = fmt::format("{} ({}): {}", broken.name, broken.rule, failure.found),
      .lines = fmt::format(
          "written: {} ({} and {}; found with {} and {})\n{}{}", path,
          plain_counted(step_count(shrunk.scenario), "frame"),
          plain_counted(shrunk.scenario.events.size(), "event"), step_count(failure.scenario),
          failure.scenario.events.size(),
          shrunk.fails_again ? "" : "it did not fail again: what it does depends on more than the scenario\n",
          request.printing.is_quiet()
              ? ""
              : "  " +
                    (failure.broken ? program_command({"study", "hard-cases", as_argument(path), "--gate",
                                                       "--no-figures"})
                                    : program_command({"run", as_argument(path)})) +
                    "\n"),
      .json = {{"run", run},
               {"rule", broken.name},
               {"found", failure.found},
               {"steps_before", step_count(failure.scenario)},
               {"events_before", std::ssize(failure.scenario.events)},
               {"scenario", path},
               {"steps", step_count(shrunk.scenario)},
               {"events", std::ssize(shrunk.scenario.events)},
               {"trials", shrunk.trials},
               {"fails_again", shrunk.fails_again}}};
}

ExitCode run_fuzz(const Core& core, const FuzzRequest& request) {
  return fuzz<FuzzFailure>(
      request, "invariant", [&](std::uint64_t run) { return play(core, request, run); },
      [&](std::uint64_t run, const FuzzFailure& failure) { return find(core, request, run, failure); });
}

void declare(Options& options, FuzzRequest& request) {
  declare_fuzz(options, request, "an invariant", fuzzed_rules());
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
