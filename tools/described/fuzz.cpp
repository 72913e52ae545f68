#include <algorithm>
#include <map>
#include <mutex>

#include "sim/result/number_text.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/library/fuzz_flow.h"
#include "tools/described/broken_rule.h"
#include "tools/described/commands.h"
#include "tools/described/random_scenario.h"
#include "tools/described/scenario_json.h"
#include "tools/files/printable.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

// The first property that does not hold at row 0; empty: none. Such a start is none of the core's.
std::string broken_at_start(const std::vector<BrokenRule>& rules) {
  const auto found = std::ranges::find_if(
      rules, [](const BrokenRule& broken) { return broken.rule == "always" && broken.step == 0; });
  return found == rules.end() ? "" : found->of;
}

// How many starts were drawn again, by the property that did not hold.
struct DrawnAgain {
  std::mutex mutex = {};
  std::map<std::string, std::int64_t> counts = {};
};

FuzzNote note_of(const DrawnAgain& again) {
  FuzzNote note;
  Json::Array json;
  for (const auto& [property, count] : again.counts) {
    note.lines += fmt::format("{} drawn again: \"{}\" does not hold at row 0\n", counted(count, "start"),
                              printable(property));
    json.push_back(Json::Object{{"property", property}, {"starts", count}});
  }
  note.json = {{"drawn_again", std::move(json)}};
  return note;
}

// A run whose properties hold at row 0, or else the scenario that it is drawn from.
DescribedScenario draw(const DescribedCore& core, const std::vector<DescribedScenario>& library,
                       const FuzzRequest& request, std::uint64_t run, DrawnAgain& again) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    DescribedScenario scenario =
        random_scenario(core.description, library, request.first_seed(), run, attempt);
    if (attempt == kLastAttempt || request.allows("always") || core.description.properties.empty())
      return scenario;
    const std::string broken =
        broken_at_start(broken_rules(core, scenario, [](std::string_view) { return false; }));
    if (broken.empty()) return scenario;
    const std::lock_guard lock(again.mutex);
    ++again.counts[broken];
  }
}

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
    std::vector<BrokenRule> rules = broken_rules(core, smaller, asks);
    if (broken.step > 0 && !broken_at_start(rules).empty()) rules.clear();
    return rules;
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
  DrawnAgain again;
  return fuzz<FuzzFailure>(
      request, "rule",
      [&](std::uint64_t run) -> std::optional<FuzzFailure> {
        DescribedScenario scenario = draw(core, library, request, run, again);
        std::optional<BrokenRule> broken = broken_by(core, scenario, request);
        if (!broken) return std::nullopt;
        return FuzzFailure{std::move(scenario), *std::move(broken)};
      },
      [&](std::uint64_t run, const FuzzFailure& failure) { return find(core, request, run, failure); },
      [&] { return note_of(again); });
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
