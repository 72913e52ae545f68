#include "tools/app/causes/core_check.h"

#include <fmt/format.h>

#include <map>

#include "sim/cause/cause_groups.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/scenario_changes.h"

namespace hyrax {
namespace {

// One group, however many they are: what was changed in the first stands for all.
DifferenceGroup changed_golden_files(const std::vector<const ScenarioVerdict*>& scenarios) {
  std::string detail = pair_of(*scenarios.front()).comparison.shape;
  const std::size_t more = scenarios.size() - 1;
  if (more > 0) detail += fmt::format("; {} more {} changed", more, more == 1 ? "was" : "were");
  return make_group({CauseKind::golden, detail}, scenarios);
}

// Of the scenarios of one golden folder. Runs that become non-finite have a group of their own.
void add_groups(const std::vector<const PairVerdict*>& scenarios, CoreCheck& core,
                std::vector<DifferenceGroup>& groups) {
  std::vector<DifferingRun> runs;
  for (const PairVerdict* const scenario : scenarios) {
    const auto& [golden, fresh, is_as_blessed, core_name, is_repeated] = *scenario->runs;
    runs.push_back({golden, fresh, scenario_changes(golden.scenario, fresh.scenario), is_as_blessed,
                    core.covers(core_name), is_repeated});
  }
  std::vector<const StoredRun*> core_runs;
  for (const CauseGroup& group : group_by_cause(runs, core.base())) {
    std::vector<const ScenarioVerdict*> members;
    for (const std::size_t run : group.runs) {
      if (non_finite_text(*scenarios[run]).empty()) members.push_back(scenarios[run]);
      if (group.cause.kind == CauseKind::core) core_runs.push_back(&runs[run].fresh);
    }
    if (members.empty()) continue;
    groups.push_back(make_group(group.cause, std::move(members)));
    groups.back().is_proved = group.cause.kind == CauseKind::core;
  }
  core.take_core_runs(core_runs);
}

}  // namespace

std::string non_finite_text(const PairVerdict& scenario) {
  return !scenario.runs ? "" : non_finite_text(scenario.runs->fresh.scenario, scenario.runs->fresh.final);
}

std::vector<DifferenceGroup> group_by_cause(const std::vector<const PairVerdict*>& scenarios,
                                            CoreChecks& cores) {
  std::map<std::string, std::vector<const PairVerdict*>> played;  // By golden folder.
  std::vector<const ScenarioVerdict*> damaged;
  std::vector<const ScenarioVerdict*> non_finite;
  for (const PairVerdict* const scenario : scenarios) {
    if (!scenario->runs)
      damaged.push_back(scenario);
    else
      played[scenario->golden_folder].push_back(scenario);
    if (!non_finite_text(*scenario).empty()) non_finite.push_back(scenario);
  }
  std::vector<DifferenceGroup> groups;
  if (!non_finite.empty()) {
    DifferenceGroup group = make_group({CauseKind::non_finite, ""}, std::move(non_finite));
    group.cause.detail = non_finite_text(pair_of(*group.scenarios.front()));
    groups.push_back(std::move(group));
  }
  for (const auto& [folder, members] : played) add_groups(members, cores.of(folder), groups);
  if (!damaged.empty()) groups.push_back(changed_golden_files(damaged));
  return groups;
}

}  // namespace hyrax
