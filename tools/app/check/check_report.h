// What `check` found as one value, and the forms in which it is reported.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "tools/app/causes/difference_group.h"
#include "tools/app/check/check_verdict.h"
#include "tools/app/library/check_flow.h"

namespace hyrax {

/// The verdicts, and the differing ones by cause; nothing is explained where all agree. What is reported of
/// them: entries and paragraphs, of which every form but the JSON document is made. REQUIRES: no copies:
/// verdicts, groups and paragraphs refer to each other.
struct CheckReport : CheckWords {
  CheckReport(CheckSelection of, std::vector<CheckVerdict> on, const Core& core)
      : selection(std::move(of)),
        verdicts(std::move(on)),
        cores(core, selection.arguments, selection.golden_option) {}

  CheckSelection selection;
  std::vector<CheckVerdict> verdicts;
  CoreChecks cores;  ///< Of every golden folder that scenarios have.
  std::vector<DifferenceGroup> groups{};

  [[nodiscard]] std::int64_t count(CheckStatus status) const {
    return std::ranges::count(verdicts, status, &CheckVerdict::status);
  }
  /// Unreferenced golden files and folders are no scenarios.
  [[nodiscard]] std::int64_t scenario_count() const {
    return std::ranges::count_if(verdicts, &CheckVerdict::is_scenario);
  }
};

/// Finds renamed scenarios, and groups the differing ones by cause. Then the cores are judged.
void explain(CheckReport& report);
/// Fills entries, paragraphs and counts.
void put_into_words(CheckReport& report);

/// The verdict on a scenario of one of its groups.
[[nodiscard]] inline const CheckVerdict& verdict_on(const PairVerdict& scenario) {
  return static_cast<const CheckVerdict&>(scenario);
}

/// What is wrong with one scenario, in one line without its path: the cause and how far it moves the run, or
/// where it becomes non-finite; the expectations that do not hold; what is missing. Empty if it agrees.
[[nodiscard]] std::string verdict_sentence(const CheckVerdict& verdict);

/// All that is known of one scenario, with the commands that show more. Complete lines, indented by two.
[[nodiscard]] std::string verdict_details(const CheckVerdict& verdict, bool lists_all = false);

/// How to accept what differs: the command that blesses it, unless a run becomes non-finite, and before it
/// what in `expect` keeps bless from doing so, and which golden file was changed since it was blessed.
/// Complete lines, indented by two.
/// @param paths scenarios, or folders of them, that are blessed.
/// @param verdicts on all scenarios of `paths`; one of them differs.
[[nodiscard]] std::string acceptance_text(const std::vector<std::string>& paths,
                                          const std::vector<const CheckVerdict*>& verdicts);

/// Every scenario, with all that is known of it.
void print_verdicts(const CheckReport& report);

[[nodiscard]] Json check_json(const CheckReport& report);
/// The paths of the worst scenario of each of the first causes.
[[nodiscard]] std::vector<Figure> check_figures(const CheckReport& report);

}  // namespace hyrax
