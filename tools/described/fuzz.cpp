#include "tools/app/command_line/shell_command.h"
#include "tools/app/library/fuzz_flow.h"
#include "tools/described/broken_rule.h"
#include "tools/described/commands.h"
#include "tools/described/random_scenario.h"
#include "tools/described/scenario_json.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

// The first rule that the run breaks and may not.
std::optional<BrokenRule> broken_by(const DescribedCore& core, const DescribedScenario& scenario,
                                    const FuzzRequest& request) {
  const auto asks = [&](std::string_view rule) { return !request.allows(std::string(rule)); };
  for (BrokenRule& broken : broken_rules(core, scenario, asks))
    if (!request.allows(broken.rule)) return std::move(broken);
  return {};
}

struct FuzzFailure {
  DescribedScenario scenario;
  BrokenRule broken;
};

FuzzFinding find(const DescribedCore& core, const FuzzRequest& request, std::uint64_t run,
                 const FuzzFailure& failure) {
  const BrokenRule& broken = failure.broken;
  const auto find_again = [&](const auto& smaller, const auto& asks) {
    return broken_rules(core, smaller, asks);
  };
  DescribedScenario scenario = shrunk(find_again, failure.scenario, broken, [] { return false; }).scenario;
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
        std::optional<BrokenRule> broken = broken_by(core, scenario, request);
        if (!broken) return std::nullopt;
        return FuzzFailure{std::move(scenario), *std::move(broken)};
      },
      [&](std::uint64_t run, const FuzzFailure& failure) { return find(core, request, run, failure); });
}

void declare(Options& options, FuzzRequest& request) {
  declare_fuzz(options, request, "a rule", {kGeneralRules.begin(), kGeneralRules.end()});
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
