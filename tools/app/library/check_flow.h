// `check` for any core: what it is asked for, which scenarios it plays, and the forms of its report.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/result/figure.h"
#include "tools/app/command_line/command_results.h"
#include "tools/app/command_line/options.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/library/difference_group.h"
#include "tools/files/golden_place.h"
#include "tools/store/output_guard.h"

namespace hyrax {

struct CheckRequest {
  std::vector<std::string> files;
  std::string golden_folder;
  std::optional<std::int64_t> jobs;
  std::string junit;
  std::string annotate;
  std::string summary;
  std::string page;
  std::string filter;
  bool lists = false;
  bool takes_last_failed = false;
  bool judges_core_only = false;
  std::string unnoticed_folder;        ///< Of a core whose step is traced,
  std::optional<std::int64_t> flings;  ///< and of the paper's.
  Printing printing;
};
/// All but --unnoticed, --flings and how it prints. @param shown what the page shows besides the report.
void declare_check(Options& options, CheckRequest& request, const std::string& shown,
                   const std::string& core_help);

/// Which scenarios did not agree the last time: a file for each folder in which `check` is run, in
/// $XDG_CACHE_HOME/hyrax-sim or ~/.cache/hyrax-sim. Without these folders, or where they cannot be read or
/// written, nothing is recorded.
class LastFailed {
 public:
  /// Reads what was recorded in the current folder.
  LastFailed();

  /// Whether the scenario, or golden file without one, did not agree.
  [[nodiscard]] bool contains(const std::string& path) const;
  /// Records the new verdicts; those of a folder that were not asked for this time are kept. Writes no file
  /// in a golden folder.
  void update(const std::vector<ScenarioVerdict*>& verdicts, OutputGuard& guard);

 private:
  std::string file_;             // Empty: nothing is recorded.
  std::set<std::string> paths_;  // Absolute.
};

struct CheckSelection {
  std::vector<std::string> arguments;  ///< Scenarios and folders as given; none: the folder `scenarios`.
  std::string golden_option;           ///< As given; empty if it was not.
  std::vector<std::string> paths = {};
  std::vector<UnreferencedGolden> unreferenced = {};
  std::vector<Failure> unlisted = {};  ///< Folders whose scenarios are not among the paths.
  bool has_failed_only = false;        ///< Only those that failed when the folder was last checked.
};

/// Sets default folders; of --core alone no scenario is selected.
/// ERRORS: Failure(bad_input) for options that do not go together, and if there is nothing to report.
[[nodiscard]] CheckSelection select(CheckRequest& request, const LastFailed& last_failed);
/// Prints the paths.
[[nodiscard]] ExitCode list(const CheckSelection& selection, const CheckRequest& request);
/// Admits all files that are asked for.
[[nodiscard]] OutputGuard guard_outputs(const CheckSelection& selection, const CheckRequest& request);

/// The libraries that are played whole: their folder `scenarios` is an argument.
[[nodiscard]] std::vector<Library> whole_libraries(const CheckRequest& request, bool has_failed_only);
/// For --core. ERRORS: Failure(bad_input) without any.
[[nodiscard]] std::vector<Library> required_libraries(const CheckRequest& request);

/// Each worker checks the next scenario until none is left. Golden files are read, in a child process first,
/// only after the workers have ended; and so are scenarios played again for which there was not enough
/// memory.
/// @param check whether scenario INDEX is decided; what it throws is not, if golden files were not read.
/// @param before_reading is called when the workers have ended.
void check_all(std::size_t scenarios, const std::optional<std::int64_t>& jobs,
               const std::function<bool(std::size_t index, bool reads_golden)>& check,
               const std::function<void()>& before_reading);

/// Does the work of one scenario, whose verdict has its path; an error becomes part of the verdict.
void judge_scenario(ScenarioVerdict& verdict, const std::string& golden_option, bool reads_golden,
                    const std::function<void()>& work);
void judge_unreferenced(ScenarioVerdict& verdict, const UnreferencedGolden& golden);

/// The verdicts, and the differing ones by cause. REQUIRES: the verdicts outlive it; no copies: groups and
/// verdicts refer to each other.
struct CheckReport {
  template <class Verdict>
  CheckReport(CheckSelection of, std::vector<Verdict>& on) : selection(std::move(of)) {
    for (Verdict& verdict : on) verdicts.push_back(&verdict);
  }

  CheckSelection selection;
  std::vector<ScenarioVerdict*> verdicts{};
  std::vector<DifferenceGroup> groups{};
  // What is reported, in whichever form.
  std::vector<ReportEntry> entries{};  ///< Of each cause the worst first; then by their paths.
  std::vector<Paragraph> paragraphs{};
  std::string counts{};  ///< "3 checked: 2 agreed, ...".

  [[nodiscard]] std::int64_t count(CheckStatus status) const {
    return std::ranges::count(verdicts, status, &ScenarioVerdict::status);
  }
  /// Unreferenced golden files and folders are no scenarios.
  [[nodiscard]] std::int64_t scenario_count() const {
    return std::ranges::count_if(verdicts, &ScenarioVerdict::is_scenario);
  }
};

/// What is said of the core of a golden folder.
struct CoreWords {
  std::string golden_folder;
  ExitCode exit_code = ExitCode::agreed;
  std::string text;       ///< Complete lines; empty of the accepted one.
  std::string file = {};  ///< In which its first change is; empty: not known.
  std::int64_t line = 0;

  /// @param changes values that are a HeaderChange.
  void mark_first_of(const auto& changes) {
    const auto change = std::ranges::find_if(changes, [](const HeaderChange& each) {
      return each.kind != HeaderChangeKind::removed && each.line > 0 && !each.file.empty();
    });
    if (change == changes.end()) return;
    file = change->file;
    line = change->line;
  }
};

/// Of the verdicts that differ; and finds renamed scenarios.
void set_groups(std::vector<DifferenceGroup> groups, CheckReport& report);
/// Fills entries, paragraphs and counts.
void put_into_words(const std::vector<CoreWords>& cores, CheckReport& report);
/// Every scenario, with all that is known of it.
void print_verdicts(const CheckReport& report);

/// {"checked", "agreed", "disagreed", "missing", "failed", "unreferenced"}: the head of the JSON document.
[[nodiscard]] Json::Object counts_json(const CheckReport& report);

/// Prints the document, or the paragraphs and counts (quiet: the paragraphs' sentences only), and writes what
/// is asked for. The page has a table of all entries that do not agree, and the figures.
[[nodiscard]] CommandResults report_check(const CheckRequest& request, const CheckReport& report,
                                          const Json& document, const std::vector<Figure>& figures = {});

}  // namespace hyrax
