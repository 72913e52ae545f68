#include "tools/hyrax-sim/golden/difference_group.h"

#include <algorithm>
#include <tuple>

#include "sim/explain/explain.h"
#include "sim/replay/kernel.h"
#include "tools/files/scenario_changes.h"

namespace hyrax {
namespace {

double largest_px(const Comparison& comparison) { return comparison.largest ? comparison.largest->px : 0.0; }

// Of the row at which the runs are farthest apart; nothing where no row is kept.
bool is_worse(const DifferingScenario& a, const DifferingScenario& b) {
  const auto key = [](const DifferingScenario& one) {
    return std::tuple(largest_px(*one.comparison), one.comparison->contacts.total());
  };
  return key(a) > key(b);
}

DifferenceGroup make_group(Cause cause, std::vector<DifferingScenario> scenarios) {
  DifferenceGroup group{.cause = std::move(cause), .scenarios = std::move(scenarios), .rest_shift_px = {}};
  std::ranges::stable_sort(group.scenarios, is_worse);
  for (const DifferingScenario& scenario : group.scenarios) {
    const Comparison& comparison = *scenario.comparison;
    if (comparison.difference) group.difference = std::max(group.difference, *comparison.difference);
    group.max_px = std::max(group.max_px, largest_px(comparison));
    group.contacts_moved += comparison.contacts.total();
    if (comparison.rest_shift_px)
      group.rest_shift_px = std::max(group.rest_shift_px.value_or(0.0), *comparison.rest_shift_px);
  }
  return group;
}

Cause changed_golden_file(const Comparison& comparison) {
  return {kUnknownCause, CauseKind::unknown, comparison.shape, {}, {}};
}

}  // namespace

std::vector<DifferenceGroup> group_by_cause(const std::vector<DifferingScenario>& scenarios) {
  std::vector<DifferingScenario> played;
  std::vector<DifferingRun> runs;
  std::vector<DifferenceGroup> damaged;
  for (const DifferingScenario& scenario : scenarios) {
    if (scenario.runs == nullptr) {
      damaged.push_back(make_group(changed_golden_file(*scenario.comparison), {scenario}));
      continue;
    }
    const auto& [golden, fresh, is_as_blessed] = *scenario.runs;
    played.push_back(scenario);
    runs.push_back({golden, fresh, scenario_changes(golden.scenario, fresh.scenario), is_as_blessed});
  }
  std::vector<DifferenceGroup> groups;
  for (const CauseGroup& group : explain(runs, core_kernel())) {
    std::vector<DifferingScenario> members;
    for (const std::size_t run : group.runs) members.push_back(played[run]);
    groups.push_back(make_group(group.cause, std::move(members)));
  }
  std::ranges::move(damaged, std::back_inserter(groups));
  return groups;
}

Json group_json(const DifferenceGroup& group) {
  std::vector<std::string> paths;
  for (const DifferingScenario& scenario : group.scenarios) paths.push_back(scenario.path);
  std::ranges::sort(paths);
  return Json::Object{{"operation", group.cause.operation},
                      {"kind", name_of(group.cause.kind)},
                      {"detail", group.cause.detail},
                      {"from", or_null(group.cause.from)},
                      {"to", or_null(group.cause.to)},
                      {"scenarios", Json::Array(paths.begin(), paths.end())},
                      {"reproduced", static_cast<std::uint64_t>(group.reproduced())},
                      {"class", name_of(group.difference)},
                      {"max_px", group.max_px},
                      {"contacts_moved", group.contacts_moved},
                      {"rest_shift_px", or_null(group.rest_shift_px)}};
}

}  // namespace hyrax
