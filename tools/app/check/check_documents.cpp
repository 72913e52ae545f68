// The report of `check` as JSON, and its figures.
#include <algorithm>

#include "sim/compare/equal_times.h"
#include "sim/compare/overlay.h"
#include "tools/app/check/check_verdict.h"
#include "tools/app/expect/judged_run.h"

namespace hyrax {
namespace {

Json entry_json(const ScenarioVerdict* each) {
  const ScenarioVerdict& verdict = *each;
  Json::Object entry = result_of(verdict, name_of(verdict.status),
                                 verdict.has_golden && verdict.status != CheckStatus::failed);
  if (!verdict.broken.empty()) entry.emplace_back("expect", list_of(verdict.broken, expectation_json));
  if (!verdict.error.empty()) entry.emplace_back("error", verdict.error);
  return entry;
}

constexpr std::size_t kPicturesMax = 3;  // Of so many causes.

// The worst scenario of which both runs keep every row; nullptr: long runs keep none, nor does a golden file
// of which the summary alone was changed.
const PairVerdict* drawable(const DifferenceGroup& group) {
  for (const ScenarioVerdict* const scenario : group.scenarios)
    if (const auto& runs = pair_of(*scenario).runs;
        runs && runs->golden.rows.size() > 0 && runs->fresh.rows.size() > 0)
      return &pair_of(*scenario);
  return nullptr;
}

Figure figure_of(const PairVerdict& scenario) {
  const StoredRun& golden = scenario.runs->golden;
  const StoredRun& fresh = scenario.runs->fresh;
  Overlay overlay;
  const auto add = [&overlay](const Row& a, const Row& b) { overlay.add(a, b); };
  if (scenario.comparison.distance.is_at_equal_times)
    static_cast<void>(walk_equal_times({batches_of(golden.rows), golden.inputs},
                                       {batches_of(fresh.rows), fresh.inputs}, add));
  else
    for (std::size_t row = 0; row < std::min(golden.rows.size(), fresh.rows.size()); ++row)
      add(golden.rows.row(row), fresh.rows.row(row));
  return overlay.figure({.title = scenario.path,
                         .subtitle = scenario.consequence(),
                         .a = "golden file",
                         .b = "this program",
                         .window = fresh.scenario.window,
                         .sprite = fresh.scenario.sprite});
}

}  // namespace

Json check_json(const CheckReport& report, const CoreChecks& cores) {
  Json::Object document = counts_json(report);
  document.emplace_back("results", list_of(report.verdicts, entry_json));
  document.emplace_back("cores",
                        list_of(cores.verdicts(), [](const auto* core) { return core_json(*core); }));
  document.emplace_back("groups", list_of(report.groups, group_json));
  return document;
}

std::vector<Figure> check_figures(const CheckReport& report) {
  std::vector<Figure> figures;
  for (const DifferenceGroup& group : report.groups)
    if (const PairVerdict* const scenario = drawable(group);
        scenario != nullptr && figures.size() < kPicturesMax)
      figures.push_back(figure_of(*scenario));
  return figures;
}

}  // namespace hyrax
