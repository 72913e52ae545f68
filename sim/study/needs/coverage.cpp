#include "sim/study/needs/needs.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/result/number_text.h"
#include "sim/study/study_table.h"

namespace hyrax {

const std::vector<std::string>& coverage_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> names(kModelPartNames.begin(), kModelPartNames.end());
    for (const char* name : {"jitter", "fling", "place", "stop", "resize", "hitch", "hold"})
      names.emplace_back(name);
    return names;
  }();
  return columns;
}

std::vector<Need> coverage_of(const ScenarioNeeds& needs) {
  std::vector<Need> coverage(coverage_columns().size(), Need::not_exercised);
  for (const PartNeed& part : needs.parts) {
    const std::string kind = part.part.substr(0, part.part.find(','));
    const auto at = std::ranges::find(coverage_columns(), kind) - coverage_columns().begin();
    Need& most = coverage[static_cast<std::size_t>(at)];
    most = std::min(most, part.need);  // `needed` comes first.
  }
  return coverage;
}

std::vector<std::string> never_exercised(const std::vector<ScenarioNeeds>& scenarios) {
  std::vector<std::string> never;
  for (std::size_t column = 0; column < coverage_columns().size(); ++column)
    if (std::all_of(scenarios.begin(), scenarios.end(), [column](const ScenarioNeeds& needs) {
          return coverage_of(needs)[column] == Need::not_exercised;
        }))
      never.push_back(coverage_columns()[column]);
  return never;
}

std::set<std::uint32_t> paths_taken(const std::vector<ScenarioNeeds>& scenarios) {
  std::set<std::uint32_t> taken;
  for (const ScenarioNeeds& needs : scenarios)
    taken.insert(needs.paths_taken.begin(), needs.paths_taken.end());
  return taken;
}

Table coverage_table(const std::vector<ScenarioNeeds>& scenarios) {
  const std::string codes = "2 needed, 1 below the tolerance, 0 not exercised";
  StudyTable table("coverage", "which scenario exercises what: " + codes, scenarios);
  table.add("scenario", "", "what is played", &ScenarioNeeds::scenario);
  for (std::size_t index = 0; index < coverage_columns().size(); ++index) {
    std::string name = coverage_columns()[index];
    std::ranges::replace(name, ' ', '_');
    table.add(name, "1", coverage_columns()[index] + ": " + codes, [index](const ScenarioNeeds& needs) {
      const Need need = coverage_of(needs)[index];
      return need == Need::not_exercised ? 0 : need == Need::below ? 1 : 2;
    });
  }
  return table;
}

Verdict coverage_verdict(const std::vector<ScenarioNeeds>& scenarios, double within_px) {
  std::vector<std::int64_t> exercised(coverage_columns().size()), needed(coverage_columns().size());
  std::vector<std::string> examples(coverage_columns().size());
  for (const ScenarioNeeds& needs : scenarios) {
    const std::vector<Need> coverage = coverage_of(needs);
    for (std::size_t column = 0; column < coverage.size(); ++column) {
      if (coverage[column] != Need::not_exercised) ++exercised[column];
      if (is_unneeded(coverage[column])) continue;
      if (++needed[column] == 1) examples[column] = needs.scenario;
    }
  }
  const std::vector<std::string> never = never_exercised(scenarios);
  const std::size_t columns = exercised.size();
  Verdict verdict{fmt::format("{} of {} parts and inputs are exercised by some of {}.",
                              columns - never.size(), columns, plain_counted(scenarios.size(), "scenario")),
                  {fmt::format("What they exercise, within {:g} px:", within_px),
                   Table{"coverage",
                         "",
                         {{"part", "", "", coverage_columns()},
                          {"exercised", "1", "", std::move(exercised)},
                          {"needed", "1", "", std::move(needed)},
                          {"for_example_by", "", "", std::move(examples)}}}},
                  {}};
  if (!never.empty())
    verdict.text.push_back(fmt::format("Exercised by no scenario: {}.", fmt::join(never, ", ")));
  return verdict;
}

}  // namespace hyrax
