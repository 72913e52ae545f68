// The report of `check` as a page.
#include <fmt/format.h>

#include <algorithm>

#include "sim/compare/equal_times.h"
#include "sim/compare/overlay.h"
#include "tools/app/check/check_report.h"
#include "tools/report/result_page.h"

namespace hyrax {
namespace {

constexpr std::size_t kPicturesMax = 3;  // Of so many causes.

// The worst scenario of which both runs keep every row; nullptr: long runs keep none, nor does a golden file
// of which the summary alone was changed.
const PairVerdict* drawable(const DifferenceGroup& group) {
  const auto found = std::ranges::find_if(group.scenarios, [](const PairVerdict* scenario) {
    return scenario->runs && scenario->runs->golden.rows.size() > 0 && scenario->runs->fresh.rows.size() > 0;
  });
  return found == group.scenarios.end() ? nullptr : *found;
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
                         .subtitle = scenario_consequence(scenario),
                         .a = "golden file",
                         .b = "this program",
                         .window = fresh.scenario.window,
                         .sprite = fresh.scenario.sprite});
}

}  // namespace

void write_check_page(const CheckReport& report, const std::string& path, const std::string& command) {
  std::vector<ReportEntry> entries;
  for (const ReportEntry& entry : report.entries)
    if (entry.exit_code != ExitCode::agreed) entries.push_back(entry);
  ShownResult page{.title = report.counts, .subtitle = "hyrax-sim check"};
  for (const Paragraph& paragraph : report.paragraphs)
    page.verdict.text.emplace_back(paragraph.sentence() + (paragraph.subject.empty() ? "" : "\n") +
                                   paragraph.lines);
  for (const DifferenceGroup& group : report.groups)
    if (const PairVerdict* const scenario = drawable(group);
        scenario != nullptr && page.figures.size() < kPicturesMax)
      page.figures.push_back(figure_of(*scenario));
  if (!entries.empty())
    page.tables.push_back(
        {.name = "not_agreed",
         .long_name = "what does not agree",
         .columns = {column_of("name", "", "scenario, golden file or core", entries, &ReportEntry::name),
                     column_of("verdict", "", "", entries, &ReportEntry::kind),
                     column_of("sentence", "", "what is wrong", entries, &ReportEntry::sentence)}});
  write_result_page(path, command, {page});
}

}  // namespace hyrax
