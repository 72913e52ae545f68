// `bless` for any core: golden files of scenarios, of deleted ones, and the accepted core.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/compare/expectations.h"
#include "tools/app/command_line/options.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/library/report_documents.h"
#include "tools/app/library/scenario_verdict.h"

namespace hyrax {

/// What --prune finds of the golden files that `check` reports for the same arguments as unreferenced.
struct Pruning {
  std::vector<std::string> removed;  ///< Files that bless wrote, .h5 and .txt each; of a link, the link.
  std::vector<std::string> left;     ///< Others, which stay.
};

/// Removes nothing yet.
/// @param is_golden_h5 whether bless wrote a .h5 file.
/// @param folders named `scenarios`, or below one.
/// ERRORS: Failure(bad_input) for another argument, for a folder without any scenario, and if the way to its
/// golden files is a link; Failure(cannot_access) if a folder cannot be changed. Failure of any kind if a
/// folder, a link or a scenario cannot be read: there may be scenarios that are not seen.
/// REQUIRES: as read_isolated.
[[nodiscard]] Pruning find_prunable(const std::vector<std::string>& folders, const std::string& golden_folder,
                                    const std::function<bool(const std::string& path)>& is_golden_h5);

/// ERRORS: Failure(cannot_access) "PATH: cannot be removed: REASON"; those before it are removed.
void remove_files(const std::vector<std::string>& files);

struct BlessRequest {
  std::vector<std::string> files;
  std::string reason;         ///< One line.
  std::string golden_folder;  ///< As given with --golden; empty if it was not.
  std::string accepted = std::string(name_of(DifferenceClass::rounding));  ///< The widest class.
  bool updates_ranges = false;  ///< And what else of `expect` is_updatable.
  bool updates_hash = false;    ///< Of `expect`, where it is there.
  bool is_dry_run = false;
  bool prunes = false;
  bool accepts_core_only = false;
  Printing printing;

  /// With --prune alone nothing is blessed.
  [[nodiscard]] bool blesses() const { return !prunes || !reason.empty(); }
  [[nodiscard]] bool accepts(DifferenceClass difference) const;
};
/// @param fixed what of `expect` is not updated, besides booleans and one-sided limits.
void declare_bless(Options& options, BlessRequest& request, const std::string& fixed,
                   const std::string& verbose_help);

struct Blessing {
  enum class Status { fresh, changed, unchanged, refused, failed };
  std::shared_ptr<ScenarioVerdict> verdict;  ///< Never null.
  Status status = Status::unchanged;
  std::string scenario_read;    ///< The scenario file's text, and
  std::string golden_read;      ///< the state of the golden pair's files, when they were read.
  bool keeps_h5 = false;        ///< Only the summary is written.
  std::string renewed_summary;  ///< Of a pair that agrees, where it is of an older layout; else empty.
  std::string unreadable;       ///< Why the golden file cannot be read; else empty.
  std::optional<DifferenceClass> differs_in;  ///< What has to be accepted; nothing: nothing has to be.
  std::optional<std::string> scenario_text;   ///< The scenario file with its new `expect`, where it changes.
  bool has_new_hash = false;                  ///< expect.state_hash changes there,
  std::vector<Expectation> updated;           ///< and what else.

  [[nodiscard]] bool has_failed() const { return status == Status::failed; }
  [[nodiscard]] bool writes_golden_file() const {
    return status == Status::fresh || status == Status::changed;
  }
  [[nodiscard]] bool writes() const {
    return writes_golden_file() || (status == Status::unchanged && scenario_text);
  }
  /// One that fails for another reason may be another run as well.
  [[nodiscard]] bool plays_otherwise() const {
    return status != Status::fresh && unreadable.empty() && verdict->differs();
  }
};

/// What becomes of the accepted core of one golden folder.
struct CoreAcceptance {
  std::string golden_folder;
  AcceptedCore core = {};  ///< This program's.
  std::string why_not =
      {};                   ///< As "3 of 99 scenarios do not agree, the first is ..."; empty: it is accepted.
  bool is_refused = false;  ///< Then nothing is written: --accept does not allow another class.
  std::string unnoticed = {};  ///< What no scenario shows of it: complete lines.
};

struct BlessReport {
  std::vector<Blessing> blessings = {};
  Pruning pruning = {};
  std::vector<CoreAcceptance> cores = {};
  bool is_written = false;

  [[nodiscard]] std::int64_t count(Blessing::Status status) const {
    return std::ranges::count(blessings, status, &Blessing::status);
  }
};

/// What `bless` says of the runs that differ.
struct BlessWords {
  std::vector<Paragraph> paragraphs = {};
  Json::Array groups = {};
};

/// What `bless` does with one kind of core. Verdicts are those that it made.
class Blesser {
 public:
  Blesser() = default;
  Blesser(const Blesser&) = delete;
  Blesser& operator=(const Blesser&) = delete;
  virtual ~Blesser() = default;

  /// A verdict on nothing yet.
  [[nodiscard]] virtual std::shared_ptr<ScenarioVerdict> verdict() const = 0;
  /// Reads the scenario of the verdict from a text of its file.
  virtual void parse(ScenarioVerdict& verdict, const std::string& text) const = 0;
  /// Plays the scenario, and sets what has to be blessed: status, keeps_h5, renewed_summary, differs_in.
  /// ERRORS: Failure(bad_input) where the golden file cannot be read, without effect.
  virtual void compare(Blessing& blessing) const = 0;
  /// The same, without its golden file: the verdict on its run alone.
  virtual void compare_none(Blessing& blessing) const = 0;
  /// Sets faults, broken, expects_hash and state_hash of a scenario that was played.
  virtual void judge(ScenarioVerdict& verdict) const = 0;
  /// Writes its golden pair.
  virtual void write_pair(const Blessing& blessing, const std::string& reason) const = 0;
  /// The verdict of `check` on a scenario of a library; one that agrees may have faults.
  [[nodiscard]] virtual std::shared_ptr<ScenarioVerdict> check(const std::string& path,
                                                               const std::string& golden_option) const = 0;
  [[nodiscard]] virtual AcceptedCore program_core() const = 0;
  /// What of this program's core no scenario shows: complete lines.
  [[nodiscard]] virtual std::string unnoticed(const Library&) const { return {}; }
  [[nodiscard]] virtual bool is_golden_h5(const std::string& path) const = 0;
  [[nodiscard]] virtual BlessWords words(const BlessReport& report, const BlessRequest& request) const = 0;
};

/// Plans a scenario each, once; refuses those that share a golden file, whose expectations do not hold,
/// whose difference is wider than accepted, or whose files cannot be written. Nothing is written. An error is
/// printed, and becomes a failed blessing.
[[nodiscard]] std::vector<Blessing> plan_blessings(const Blesser& blesser,
                                                   const std::vector<std::string>& paths,
                                                   const BlessRequest& request);

/// Writes what was planned: the summary, then the rows, then the scenario file. An error is printed, and the
/// blessing has failed. REQUIRES: blessing.writes().
void write(const Blesser& blesser, Blessing& blessing, const std::string& reason);

/// Of a report that was written, a sentence for each golden folder of which git ignores a file that was
/// written.
[[nodiscard]] std::vector<std::string> git_ignored_sentences(const BlessReport& report);

/// All checks come before the first write: if one fails, no golden file is changed.
[[nodiscard]] ExitCode bless(const Blesser& blesser, BlessRequest& request);

// New values of `expect` in the text of a scenario; nothing else in it changes.

/// With new values for ranges that do not hold: they keep their width; counts become the new ones.
/// REQUIRES: is_updatable_range of each.
[[nodiscard]] std::string with_updated_ranges(std::string text, const std::vector<Expectation>& ranges);

/// REQUIRES: `expect` has a state hash.
[[nodiscard]] std::string with_updated_hash(const std::string& text, const std::string& state_hash);

}  // namespace hyrax
