// What `check` found, and the forms in which it is reported.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "sim/core/core.h"
#include "tools/app/causes/difference_group.h"
#include "tools/app/check/check_verdict.h"
#include "tools/app/command_line/print.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"

namespace hyrax {

/// The verdicts, and the differing ones by cause. Nothing is explained where all agree.
class CheckReport {
 public:
  /// Refers to the core.
  /// @param unlisted folders whose scenarios are not among the verdicts.
  /// @param arguments the scenarios and folders as given; none: the folder `scenarios`.
  /// @param golden_folder as given; empty if it was not.
  CheckReport(const Core& core, std::vector<CheckVerdict> verdicts, std::vector<Failure> unlisted,
              std::vector<std::string> arguments, std::string golden_folder);
  CheckReport(const CheckReport&) = delete;
  CheckReport& operator=(const CheckReport&) = delete;

  [[nodiscard]] const std::vector<CheckVerdict>& verdicts() const { return verdicts_; }
  [[nodiscard]] const std::vector<Failure>& unlisted() const { return unlisted_; }
  [[nodiscard]] const std::vector<DifferenceGroup>& groups() const { return groups_; }
  /// Of every golden folder that scenarios have, in order of their names.
  [[nodiscard]] std::vector<const CoreVerdict*> cores() const { return cores_.verdicts(); }
  [[nodiscard]] const std::vector<std::string>& arguments() const { return arguments_; }
  [[nodiscard]] const std::string& golden_folder() const { return golden_folder_; }

  /// Looks for changes of the core that none of the libraries' scenarios notices.
  void judge_cores(const std::vector<Library>& libraries);

  [[nodiscard]] std::int64_t count(CheckStatus status) const;
  /// Unreferenced golden files and folders are no scenarios.
  [[nodiscard]] std::int64_t scenario_count() const;
  /// The group of a scenario whose run differs; nullptr: it is in none.
  [[nodiscard]] const DifferenceGroup* group_of(const CheckVerdict& verdict) const;
  /// The other half of a renamed scenario: of one whose golden file is missing the unreferenced golden file
  /// with its run, and the other way round. nullptr: it was not renamed.
  [[nodiscard]] const CheckVerdict* renamed(const CheckVerdict& verdict) const;

 private:
  std::vector<CheckVerdict> verdicts_;
  std::vector<Failure> unlisted_;
  CoreChecks cores_;
  std::vector<DifferenceGroup> groups_;
  std::unordered_map<const PairVerdict*, const DifferenceGroup*> group_of_;
  std::unordered_map<const CheckVerdict*, const CheckVerdict*> renamed_;
  std::vector<std::string> arguments_;
  std::string golden_folder_;
};

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
[[nodiscard]] std::string verdict_sentence(const CheckReport& report, const CheckVerdict& verdict);

/// All that is known of one scenario, with the commands that show more. Complete lines, indented by two.
[[nodiscard]] std::string verdict_details(const CheckReport& report, const CheckVerdict& verdict,
                                          bool lists_all = false);

/// The option of bless that accepts differences of this class, with a blank before it; empty: it needs none.
[[nodiscard]] std::string accept_option(DifferenceClass widest);

/// How to accept what differs: the commands that bless it, unless a run becomes non-finite, and before them
/// what in `expect` keeps bless from doing so, and which golden file was changed since it was blessed.
/// Complete lines, indented by two.
/// @param paths scenarios, or folders of them, that are blessed.
/// @param options of bless, each with a blank before it; --update-hash or --update-expect is added where it
/// is needed.
/// @param verdicts on all scenarios of `paths`; one of them differs.
[[nodiscard]] std::string acceptance_text(const std::vector<std::string>& paths, const std::string& options,
                                          const std::vector<const CheckVerdict*>& verdicts);

/// A paragraph for each cause, a line for each kind of what is wrong otherwise, the commands that show more,
/// and the counts (verbose: every scenario first; quiet: names and counts only, failures on standard error).
void print_check(const CheckReport& report, const Printing& printing);

[[nodiscard]] Json check_json(const CheckReport& report);
[[nodiscard]] std::string check_junit(const CheckReport& report);
/// Workflow commands of GitHub Actions, "::error file=PATH,title=TITLE::MESSAGE", a line for each scenario
/// that does not agree, of each cause the worst scenario first, and for each other failure.
[[nodiscard]] std::string github_annotations(const CheckReport& report);
/// What was drawn of a group: names of files beside the summary; empty: none.
struct GroupPicture {
  std::string svg;      ///< Both paths of the worst scenario, and their distance over time.
  std::string html;     ///< A page that plays it.
  std::string missing;  ///< Why something could not be drawn.
};

/// The report in Markdown.
/// @param pictures of the first groups.
[[nodiscard]] std::string check_markdown(const CheckReport& report,
                                         const std::vector<GroupPicture>& pictures);

/// So many causes get a picture.
inline constexpr std::size_t kPicturesMax = 3;

/// The files that may be written for the summary at `path`, FILE.md: FILE-1.svg and so on, in the order of
/// the groups, then FILE.html.
[[nodiscard]] std::vector<std::string> picture_paths(const std::string& path);

/// Draws both paths of the worst scenario of each of the first groups, and writes the page on which the worst
/// of all can be played, where this program has the page. What cannot be drawn changes no verdict: the text
/// says why.
[[nodiscard]] std::vector<GroupPicture> write_pictures(const Core& core, const CheckReport& report,
                                                       const std::string& path);

}  // namespace hyrax
