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

struct FuzzFailure {
  DescribedScenario scenario;
  BrokenRule broken;
};

// The first rule that the run breaks and may not. Its start is drawn again while a property does not hold at
// row 0, at last as that of the scenario that it is drawn from.
std::optional<FuzzFailure> failure_of(const DescribedCore& core,
                                      const std::vector<DescribedScenario>& library,
                                      const FuzzRequest& request, std::uint64_t run, DrawnAgain& again) {
  const auto is_asked = [&](std::string_view rule) { return !request.allows(std::string(rule)); };
  for (std::uint64_t attempt = 0;; ++attempt) {
    DescribedScenario scenario =
        random_scenario(core.description, library, request.first_seed(), run, attempt);
    std::vector<BrokenRule> rules = broken_rules(core, scenario, is_asked);
    const std::string property =
        attempt == kLastAttempt || request.allows("always") ? "" : broken_at_start(rules);
    if (property.empty()) {
      const auto first = std::ranges::find_if(rules, is_asked, &BrokenRule::rule);
      if (first == rules.end()) return std::nullopt;
      return FuzzFailure{std::move(scenario), std::move(*first)};
    }
    const std::lock_guard lock(again.mutex);
    ++again.counts[property];
  }
}

FuzzFinding find(const DescribedCore& core, const FuzzRequest& request, std::uint64_t run,
                 const FuzzFailure& failure) {
  const auto find_again = [&](const auto& smaller, const auto& asks) {
    std::vector<BrokenRule> rules = broken_rules(core, smaller, asks);
    if (failure.broken.step > 0 && !broken_at_start(rules).empty()) rules.clear();
    return rules;
  };
  auto [scenario, broken, trials, is_complete] =
      shrunk(find_again, failure.scenario, failure.broken, [] { return false; });
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
      request, "rule", [&](std::uint64_t run) { return failure_of(core, library, request, run, again); },
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
