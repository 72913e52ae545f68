#include "tools/app/causes/difference_group.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "sim/cause/cause_groups.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/scenario_changes.h"

namespace hyrax {
namespace {

std::tuple<double, std::int64_t> badness(const PairVerdict* scenario) {
  return {scenario->comparison.distance.px(), scenario->comparison.contacts.total()};
}

DifferenceGroup make_group(Cause cause, std::vector<const PairVerdict*> scenarios) {
  DifferenceGroup group{
      .cause = std::move(cause), .scenarios = std::move(scenarios), .contacts = {}, .rest_shift_px = {}};
  std::ranges::stable_sort(group.scenarios, std::ranges::greater(), badness);
  for (const PairVerdict* const scenario : group.scenarios) {
    const Comparison& comparison = scenario->comparison;
    if (comparison.difference) group.difference = std::max(group.difference, *comparison.difference);
    group.max_px = std::max(group.max_px, comparison.distance.px());
    group.contacts += comparison.contacts.counts();
    if (const std::optional<double> shift_px = comparison.rest_shift_px()) {
      ++group.settled;
      group.rest_shift_px = std::max(group.rest_shift_px.value_or(0.0), *shift_px);
    }
  }
  return group;
}

// One group, however many they are: what was changed in the first stands for all.
DifferenceGroup changed_golden_files(const std::vector<const PairVerdict*>& scenarios) {
  std::string detail = scenarios.front()->comparison.shape;
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
    std::vector<const PairVerdict*> members;
    for (const std::size_t run : group.runs) {
      if (non_finite_text(*scenarios[run]).empty()) members.push_back(scenarios[run]);
      if (group.cause.kind == CauseKind::core) core_runs.push_back(&runs[run].fresh);
    }
    if (!members.empty()) groups.push_back(make_group(group.cause, std::move(members)));
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
  std::vector<const PairVerdict*> damaged;
  std::vector<const PairVerdict*> non_finite;
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
    group.cause.detail = non_finite_text(*group.scenarios.front());
    groups.push_back(std::move(group));
  }
  for (const auto& [folder, members] : played) add_groups(members, cores.of(folder), groups);
  if (!damaged.empty()) groups.push_back(changed_golden_files(damaged));
  return groups;
}

Json group_json(const DifferenceGroup& group) {
  std::vector<std::string> paths;
  for (const PairVerdict* const scenario : group.scenarios) paths.push_back(scenario->path);
  std::ranges::sort(paths);
  return Json::Object{{"operation", name_of(group.cause.kind)},
                      {"detail", group.cause.detail},
                      {"scenarios", Json::Array(paths.begin(), paths.end())},
                      {"class", name_of(group.difference)},
                      {"max_px", group.max_px},
                      {"contacts_moved", group.contacts.total()},
                      {"rest_shift_px", or_null(group.rest_shift_px)}};
}

}  // namespace hyrax
