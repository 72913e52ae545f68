#include "sim/described/described_run.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/library/fuzz_flow.h"
#include "tools/described/commands.h"
#include "tools/described/random_scenario.h"
#include "tools/described/scenario_json.h"
#include "tools/files/path.h"
#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

const std::vector<std::string> kFuzzedRules = {"throws", "finite", "always", "complete"};

struct Broken {
  std::string rule = {};
  std::string found = {};
  std::int64_t step = 0;  ///< Where it is known; else the last.
};

// The first rule that the run breaks and may not.
std::optional<Broken> broken_by(const DescribedCore& core, const DescribedScenario& scenario,
                                const FuzzRequest& request) {
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
    if (!request.allows(broken.rule)) return broken;
  return {};
}

// Shorter and with fewer events and values, as long as it breaks the same rule.
DescribedScenario shrunk(const DescribedCore& core, DescribedScenario scenario, Broken broken) {
  FuzzRequest others;
  others.without = kFuzzedRules;
  std::erase(others.without, broken.rule);
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

struct FuzzFailure {
  DescribedScenario scenario;
  Broken broken;
};

FuzzFinding find(const DescribedCore& core, const FuzzRequest& request, std::uint64_t run,
                 const FuzzFailure& failure) {
  const Broken& broken = failure.broken;
  DescribedScenario scenario = shrunk(core, failure.scenario, broken);
  const std::string path = failure_path(request, scenario.name);
  scenario.description = fmt::format("Run {} of {}-sim fuzz --seed {}: breaks {}: {}.", run,
                                     core.description.core, request.first_seed(), broken.rule, broken.found);
  write_text_file(path, to_text(to_json(core.description, scenario), 1) + "\n");
  return {.sentence = fmt::format("{}: {}", broken.rule, broken.found),
          .lines = fmt::format("written: {}\n  {}\n", path, program_command({"run", as_argument(path)})),
          .json = {{"run", run}, {"rule", broken.rule}, {"found", broken.found}, {"scenario", path}}};
}

ExitCode fuzz_described(const DescribedCore& core, const FuzzRequest& request) {
  const std::vector<DescribedScenario> library = library_or_defaults(core.description);
  return fuzz<FuzzFailure>(
      request, "rule",
      [&](std::uint64_t run) -> std::optional<FuzzFailure> {
        DescribedScenario scenario = random_scenario(core.description, library, request.first_seed(), run);
        std::optional<Broken> broken = broken_by(core, scenario, request);
        if (!broken) return std::nullopt;
        return FuzzFailure{std::move(scenario), *std::move(broken)};
      },
      [&](std::uint64_t run, const FuzzFailure& failure) { return find(core, request, run, failure); });
}

void declare(Options& options, FuzzRequest& request) {
  declare_fuzz(options, request, "a rule", kFuzzedRules);
}

}  // namespace

Command described_fuzz_command(const DescribedCore& core) {
  return {.name = "fuzz",
          .summary = "play random scenarios and check what must hold in every run",
          .example = "hyrax-sim fuzz --runs 1000 --seed 7 --without always -o failures",
          .declare = with_request<FuzzRequest>(
              declare, [&core](const FuzzRequest& request) { return fuzz_described(core, request); })};
}

}  // namespace hyrax
