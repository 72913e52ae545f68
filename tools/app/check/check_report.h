// What `check` found as one value, and the forms in which it is reported.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "tools/app/causes/difference_group.h"
#include "tools/app/check/check_verdict.h"
#include "tools/app/command_line/print.h"
#include "tools/app/library/report_documents.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"

namespace hyrax {

/// The verdicts, and the differing ones by cause; nothing is explained where all agree. What is reported of
/// them: entries and paragraphs, of which every form but the JSON document is made. REQUIRES: no copies:
/// verdicts, groups and paragraphs refer to each other.
struct CheckReport {
  std::vector<CheckVerdict> verdicts;
  std::vector<Failure> unlisted;       ///< Folders whose scenarios are not among the verdicts.
  std::vector<std::string> arguments;  ///< Scenarios and folders as given; none: the folder `scenarios`.
  std::string golden_folder;           ///< As given; empty if it was not.
  CoreChecks cores;                    ///< Of every golden folder that scenarios have.
  std::vector<DifferenceGroup> groups{};
  std::vector<ReportEntry> entries{};  ///< Of each cause the worst first; then by their paths.
  std::vector<Paragraph> paragraphs{};
  std::string counts{};  ///< "3 checked: 2 agreed, ...".

  [[nodiscard]] std::int64_t count(CheckStatus status) const;
  /// Unreferenced golden files and folders are no scenarios.
  [[nodiscard]] std::int64_t scenario_count() const;
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

/// The paragraphs and the counts (verbose: every scenario first; quiet: the paragraphs' sentences only, why a
/// scenario failed on standard error).
void print_check(const CheckReport& report, const Printing& printing);

/// {"scenario", "status", "class", "max_px", ...}: how a run differs from its golden file, the first members
/// of an entry of "results" of check and bless. @param is_compared else there are no distances.
[[nodiscard]] Json::Object result_of(const PairVerdict& scenario, std::string_view status, bool is_compared);

[[nodiscard]] Json check_json(const CheckReport& report);
[[nodiscard]] std::string check_markdown(const CheckReport& report);
/// Writes the page: with the paths of the worst scenario of each of the first causes, and a table of all
/// entries that do not agree. ERRORS: as write_result_page's.
void write_check_page(const CheckReport& report, const std::string& path, const std::string& command);

}  // namespace hyrax
