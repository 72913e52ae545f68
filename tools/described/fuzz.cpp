#include <chrono>
#include <filesystem>

#include "sim/described/described_run.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/part.h"
#include "tools/app/command_line/progress.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/described/commands.h"
#include "tools/described/random_scenario.h"
#include "tools/described/scenario_json.h"
#include "tools/files/path.h"
#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

const std::vector<std::string> kFuzzedRules = {"throws", "finite", "always", "complete"};

struct FuzzDescribedRequest {
  std::optional<std::uint64_t> seed;
  std::optional<double> time_s;
  std::optional<std::int64_t> runs;
  std::vector<std::string> without;
  std::string part;
  std::optional<std::int64_t> parts;
  std::string folder = ".";
  Printing printing;
};

struct Broken {
  std::string rule = {};
  std::string found = {};
  std::int64_t step = 0;  ///< Where it is known; else the last.
};

// The first rule that the run breaks and may not.
std::optional<Broken> broken_by(const DescribedCore& core, const DescribedScenario& scenario,
                                const std::vector<std::string>& without) {
  std::vector<Broken> all;
  const DescribedSummary run = play(core, scenario, {});
  const std::int64_t steps = step_count(scenario);
  if (const auto& early = run.early_end)
    all.push_back({early->is_non_finite ? "finite" : "throws",
                   fmt::format("{} at step {}", early->what, early->step), early->step});
  for (std::size_t place = 0; place < run.properties.size(); ++place) {
    const PropertyInfo& property = core.description.properties[place];
    const std::int64_t step = run.properties[place].step.value_or(steps);
    if (property.is_always && !run.properties[place].holds)
      all.push_back({"always", fmt::format("\"{}\" at step {}", property.name, step), step});
  }
  if (const auto fault = description_fault(core, scenario, steps)) all.push_back({"complete", *fault, steps});
  for (Broken& broken : all)
    if (std::ranges::find(without, broken.rule) == without.end()) return broken;
  return {};
}

// Shorter and with fewer events and values, as long as it breaks the same rule.
DescribedScenario shrunk(const DescribedCore& core, DescribedScenario scenario, Broken broken) {
  std::vector<std::string> others = kFuzzedRules;
  std::erase(others, broken.rule);
  const auto keep_if_broken = [&](const DescribedScenario& smaller) {
    const auto again = broken_by(core, smaller, others);
    if (!again) return false;
    scenario = smaller;
    broken = *again;
    return true;
  };
  DescribedScenario smaller = scenario;
  if (!std::holds_alternative<RecordedSteps>(scenario.clock.base) && scenario.input_arrays.empty()) {
    std::erase_if(smaller.events, [&](const DescribedEvent& event) {
      return std::get<std::int64_t>(event.when) >= broken.step;
    });
    smaller.length = broken.step;
    keep_if_broken(smaller);
  }
  const auto drop_each = [&](auto member) {
    for (std::size_t index = (scenario.*member).size(); index-- > 0;) {
      smaller = scenario;
      (smaller.*member).erase((smaller.*member).begin() + static_cast<std::ptrdiff_t>(index));
      keep_if_broken(smaller);
    }
  };
  // Without a hold that is let go later there would be an event that no file may have.
  if (std::ranges::none_of(scenario.events, [](const DescribedEvent& event) {
        return std::holds_alternative<Hold>(event.action);
      }))
    drop_each(&DescribedScenario::events);
  drop_each(&DescribedScenario::parameters);
  drop_each(&DescribedScenario::inputs);
  drop_each(&DescribedScenario::start);
  return scenario;
}

// What runs are varied from: the library of the current folder, or the core's defaults.
std::vector<DescribedScenario> library_of(const DescribedCore& core) {
  std::vector<DescribedScenario> library;
  if (is_folder("scenarios"))
    for (const std::string& path : list_scenarios({"scenarios"}))
      library.push_back(load_described_scenario(core.description, path));
  if (!library.empty()) return library;
  DescribedScenario defaults;
  defaults.clock.base = FixedRate{60.0};
  defaults.length = std::int64_t{600};
  return {defaults};
}

std::string write_broken(const DescribedCore& core, const FuzzDescribedRequest& request, std::uint64_t seed,
                         std::int64_t run, const Broken& broken, DescribedScenario scenario) {
  make_folder(request.folder);
  const std::string stem = scenario.name;
  std::string path;
  for (int number = 1; path.empty() || is_there(path); ++number) {
    scenario.name = stem + (number == 1 ? "" : fmt::format("-{}", number));
    path = request.folder == "."
               ? scenario.name + ".json"
               : (std::filesystem::path(request.folder) / (scenario.name + ".json")).string();
  }
  scenario.description = fmt::format("Run {} of {}-sim fuzz --seed {}: breaks {}: {}.", run,
                                     core.description.core, seed, broken.rule, broken.found);
  write_text_file(path, to_text(to_json(core.description, scenario), 1) + "\n");
  return path;
}

ExitCode fuzz_described(const DescribedCore& core, const FuzzDescribedRequest& request) {
  if (request.time_s && request.runs) refuse_input("hyrax-sim fuzz: --time and --runs: only one allowed");
  OutputGuard({}).admit("hyrax-sim fuzz: -o", (std::filesystem::path(request.folder) / "fuzz.json").string());
  const std::vector<DescribedScenario> library = library_of(core);
  const WorkPart part = choose_part("hyrax-sim fuzz", request.part, request.parts).value_or(WorkPart{});
  const std::uint64_t seed = request.seed.value_or(1);
  const double time_s = request.time_s.value_or(60.0);
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed_s = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const std::int64_t runs_max = part.rows(request.runs.value_or(0));
  const auto is_over = [&](std::int64_t run) {
    return request.runs ? run >= runs_max : elapsed_s() >= time_s;
  };
  const bool tells = !request.printing.is_json && !request.printing.is_quiet();
  if (tells) print_text("seed {}\n", seed);
  std::fflush(stdout);  // A core that crashes ends the program: by its seed the run is played again.
  Progress progress("runs", runs_max);
  std::optional<Broken> broken;
  DescribedScenario scenario;
  std::int64_t runs = 0;
  while (!broken && !is_over(runs)) {
    scenario =
        random_scenario(core.description, library, seed, static_cast<std::uint64_t>(part.member(runs)));
    broken = broken_by(core, scenario, request.without);
    ++runs;
    if (request.runs) progress.show(runs);
  }
  const double played_s = elapsed_s();
  if (tells) print_text("{} in {:.1f} s\n", counted(runs, "run"), played_s);
  Json::Array failures;
  if (broken) {
    const std::int64_t run = part.member(runs - 1);
    scenario = shrunk(core, scenario, *broken);
    const std::string path = write_broken(core, request, seed, run, *broken, scenario);
    failures.push_back(
        Json::Object{{"run", run}, {"rule", broken->rule}, {"found", broken->found}, {"scenario", path}});
    if (!request.printing.is_json)
      print_text("run {} {}: {}: {}\nwritten: {}\n  {}\n", run, VerdictWord{"breaks a rule", false},
                 broken->rule, broken->found, path, program_command({"run", as_argument(path)}));
  } else if (!request.printing.is_json) {
    print_text("{}\n", VerdictWord{runs == 0 ? "nothing was tested" : "all rules hold", runs > 0});
  }
  if (request.printing.is_json)
    print_json(Json::Object{{"seed", seed},
                            {"part", Json::Object{{"index", part.index}, {"count", part.count}}},
                            {"without", Json::Array(request.without.begin(), request.without.end())},
                            {"runs", runs},
                            {"elapsed_s", played_s},
                            {"failures", std::move(failures)}},
               3);
  return broken ? ExitCode::disagreed : ExitCode::agreed;
}

void declare_fuzz_described(Options& options, FuzzDescribedRequest& request) {
  options.seed(request.seed, {"--seed", "N", "which scenarios are drawn (default: 1)"});
  options.time(request.time_s, {"--time", "TIME", "how long, as 60s, 5m or 2h (default: 60s)"});
  options.integer(request.runs, {"--runs", "N", "how many scenarios, instead of a time"}, 1);
  options.choices(request.without, {"--without", "RULE", "a rule that a run may break; may be repeated"},
                  kFuzzedRules, "rule");
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

Command described_fuzz_command(const DescribedCore& core) {
  return {.name = "fuzz",
          .summary = "play random scenarios and check what must hold in every run",
          .example = "hyrax-sim fuzz --runs 1000 --seed 7 --without always -o failures",
          .declare = with_request<FuzzDescribedRequest>(
              declare_fuzz_described,
              [&core](const FuzzDescribedRequest& request) { return fuzz_described(core, request); })};
}

}  // namespace hyrax
