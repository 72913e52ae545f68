// What `bless` plans and did: golden files of scenarios, of deleted ones, and the accepted core; as text and
// as JSON.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "sim/compare/expectations.h"
#include "sim/core/core.h"
#include "tools/app/causes/core_check.h"
#include "tools/app/causes/difference_group.h"
#include "tools/app/command_line/print.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/app/library/pruning.h"
#include "tools/files/json.h"

namespace hyrax {

struct BlessOptions {
  std::string reason;                                    ///< One line.
  std::string golden_folder;                             ///< As given with --golden; empty if it was not.
  DifferenceClass accepted = DifferenceClass::rounding;  ///< The widest class that may be blessed.
  bool updates_ranges = false;                           ///< And what else of `expect` is_updatable.
  bool updates_hash = false;                             ///< Of `expect`, where it is there.
};

struct Blessing : PairVerdict {
  enum class Status { fresh, changed, unchanged, refused, failed };
  Status status = Status::unchanged;
  Scenario scenario;            ///< As it is blessed: with the `expect` of scenario_text.
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
};

[[nodiscard]] std::string_view name_of(Blessing::Status status);

/// Plans every scenario, each once; refuses those that share a golden file, whose expectations do not hold,
/// whose difference is wider than accepted, or whose files cannot be written. Nothing is written. An error is
/// printed, and becomes a failed blessing.
[[nodiscard]] std::vector<Blessing> plan_blessings(const Core& core, const std::vector<std::string>& paths,
                                                   const BlessOptions& options);

/// Throws Failure(cannot_access) where a file of a blessing is not as it was read. REQUIRES: none has failed.
void require_unchanged(const std::vector<Blessing>& blessings);

/// Writes what was planned: the summary, then the rows, then the scenario file. An error is printed, and the
/// blessing has failed.
/// REQUIRES: blessing.writes().
void write(const Core& core, Blessing& blessing, const BlessOptions& options);

/// What becomes of the accepted core of one golden folder.
struct CoreAcceptance {
  std::string golden_folder;
  AcceptedCore core;        ///< This program's.
  std::string why_not;      ///< As "3 of 99 scenarios do not agree, the first is ..."; empty: it is accepted.
  bool is_refused = false;  ///< Then nothing is written: --accept does not allow another class.
  CoreVerdict differences;  ///< From the one accepted before.

  [[nodiscard]] bool is_accepted() const { return why_not.empty(); }
};

/// Of libraries_of(arguments). Plays each whole, unless its accepted core is this
/// program's already: then nothing is planned.
/// @param blessings of scenarios that will agree.
[[nodiscard]] std::vector<CoreAcceptance> plan_core_acceptances(const Core& core,
                                                                const std::vector<std::string>& arguments,
                                                                const std::vector<Blessing>& blessings,
                                                                const BlessOptions& options);

/// Writes those that are accepted; if a blessing has failed, none is.
/// ERRORS: as write_accepted_core's.
void write_cores(std::vector<CoreAcceptance>& cores, const std::vector<Blessing>& blessings);

/// "core: accepted in golden/core", or why not. Complete lines.
[[nodiscard]] std::string acceptances_text(const std::vector<CoreAcceptance>& cores, bool is_written);

struct BlessReport {
  std::vector<Blessing> blessings;
  Pruning pruning;
  std::vector<CoreAcceptance> cores;
  bool is_written = false;

  [[nodiscard]] std::int64_t count(Blessing::Status status) const {
    return std::ranges::count(blessings, status, &Blessing::status);
  }
};

/// Why nothing is written, with the option that would allow it where there is one; empty: it is written.
[[nodiscard]] std::string refusal_sentence(const BlessReport& report);

/// Of a report that was written: that some, but not all of it was; else empty.
[[nodiscard]] std::string unfinished_sentence(const BlessReport& report);

/// Of a report that was written, a sentence for each golden folder of which git ignores a file that was
/// written.
[[nodiscard]] std::vector<std::string> git_ignored_sentences(const BlessReport& report);

/// What changes, old against new, by cause, and against the accepted cores. REQUIRES: the groups do not
/// outlive the report.
[[nodiscard]] std::vector<DifferenceGroup> groups_of(const BlessReport& report, CoreChecks& cores);

void print_plans(const Core& core, const BlessReport& report, const std::vector<DifferenceGroup>& groups,
                 const CoreChecks& cores, const Printing& printing);
/// What was written, or would be.
void print_done(const BlessReport& report, bool is_dry_run);
[[nodiscard]] Json bless_json(const BlessReport& report, const std::vector<DifferenceGroup>& groups);

}  // namespace hyrax
