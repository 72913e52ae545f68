// What `check` found, and the forms in which it is reported.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "tools/app/causes/difference_group.h"
#include "tools/app/check/check_verdict.h"
#include "tools/app/command_line/print.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"

namespace hyrax {

/// The verdicts, and the differing ones by cause. Nothing is explained where all agree. REQUIRES: no copies:
/// verdicts and groups refer to each other.
struct CheckReport {
  std::vector<CheckVerdict> verdicts;
  std::vector<Failure> unlisted;       ///< Folders whose scenarios are not among the verdicts.
  std::vector<std::string> arguments;  ///< Scenarios and folders as given; none: the folder `scenarios`.
  std::string golden_folder;           ///< As given; empty if it was not.
  CoreChecks cores;                    ///< Of every golden folder that scenarios have.
  std::vector<DifferenceGroup> groups{};

  [[nodiscard]] std::int64_t count(CheckStatus status) const;
  /// Unreferenced golden files and folders are no scenarios.
  [[nodiscard]] std::int64_t scenario_count() const;
};

/// Finds renamed scenarios, and groups the differing ones by cause.
void explain(CheckReport& report);

[[nodiscard]] std::string counts_sentence(const CheckReport& report);

/// By which the check fails whatever the scenarios' verdicts are: a core, or a folder without scenarios.
struct OtherFailure {
  std::string_view kind;
  std::string file;  ///< Of the accepted core; empty: a folder, which the text names.
  std::string text;  ///< Without the last line break.
  ExitCode exit_code;
};
[[nodiscard]] std::vector<OtherFailure> other_failures(const CheckReport& report);

/// The verdict on a scenario of one of its groups.
[[nodiscard]] inline const CheckVerdict& verdict_on(const PairVerdict& scenario) {
  return static_cast<const CheckVerdict&>(scenario);
}

/// What is wrong with one scenario, in one line without its path: the cause and how far it moves the run, or
/// where it becomes non-finite; the expectations that do not hold; what is missing. Empty if it agrees.
[[nodiscard]] std::string verdict_sentence(const CheckVerdict& verdict);

/// All that is known of one scenario, with the commands that show more. Complete lines, indented by two.
[[nodiscard]] std::string verdict_details(const CheckVerdict& verdict, bool lists_all = false);

/// How to accept what differs: the commands that bless it, unless a run becomes non-finite, and before them
/// what in `expect` keeps bless from doing so, and which golden file was changed since it was blessed.
/// Complete lines, indented by two.
/// @param paths scenarios, or folders of them, that are blessed.
/// @param verdicts on all scenarios of `paths`; one of them differs.
[[nodiscard]] std::string acceptance_text(const std::vector<std::string>& paths,
                                          const std::vector<const CheckVerdict*>& verdicts);

/// A paragraph for each cause, a line for each kind of what is wrong otherwise, the commands that show more,
/// and the counts (verbose: every scenario first; quiet: names and counts only, failures on standard error).
void print_check(const CheckReport& report, const Printing& printing);

/// {"scenario", "status", "class", "max_px", ...}: how a run differs from its golden file, the first members
/// of an entry of "results" of check and bless. @param is_compared else there are no distances.
[[nodiscard]] Json::Object result_of(const PairVerdict& scenario, std::string_view status, bool is_compared);

[[nodiscard]] Json check_json(const CheckReport& report);
[[nodiscard]] std::string check_junit(const CheckReport& report);
/// Workflow commands of GitHub Actions, "::error file=PATH,title=TITLE::MESSAGE", a line for each scenario
/// that does not agree, of each cause the worst scenario first, and for each other failure.
[[nodiscard]] std::string github_annotations(const CheckReport& report);

/// So many causes get a picture.
inline constexpr std::size_t kPicturesMax = 3;

/// The files that may be written for the summary at `path`, FILE.md: FILE-1.svg and so on, in the order of
/// the groups, then FILE.html.
[[nodiscard]] std::vector<std::string> picture_paths(const std::string& path);

/// The report in Markdown, for the summary at `path`. Draws both paths of the worst scenario of each of the
/// first groups, and writes the page on which the worst of all can be played, where this program has the
/// page. What cannot be drawn changes no verdict: the text says why.
[[nodiscard]] std::string check_markdown(const Core& core, const CheckReport& report,
                                         const std::string& path);

}  // namespace hyrax
