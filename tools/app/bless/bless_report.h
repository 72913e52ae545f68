// What `bless` plans and did: golden files of scenarios, of deleted ones, and the accepted core; as text and
// as JSON.
#pragma once

#include <string>
#include <vector>

#include "sim/core/core.h"
#include "tools/app/bless/blessing.h"
#include "tools/app/causes/core_check.h"
#include "tools/app/causes/difference_group.h"
#include "tools/app/command_line/print.h"
#include "tools/app/core/accepted_core.h"
#include "tools/files/json.h"

namespace hyrax {

/// What --prune finds of the golden files that `check` reports for the same arguments as unreferenced.
struct Pruning {
  std::vector<std::string> removed;  ///< Files that bless wrote, .h5 and .txt each; of a link, the link.
  std::vector<std::string> left;     ///< Others, which stay.
};

/// Removes nothing yet.
/// @param folders named `scenarios`, or below one.
/// ERRORS: Failure(bad_input) for another argument, for a folder without any scenario, and if the way to its
/// golden files is a link; Failure(cannot_access) if a folder cannot be changed. Failure of any kind if a
/// folder, a link or a scenario cannot be read: there may be scenarios that are not seen.
/// REQUIRES: as read_isolated.
[[nodiscard]] Pruning find_prunable(const std::vector<std::string>& folders,
                                    const std::string& golden_folder);

/// ERRORS: Failure(cannot_access) "PATH: cannot be removed: REASON"; those before it are removed.
void remove_files(const std::vector<std::string>& files);

/// What becomes of the accepted core of one golden folder.
struct CoreAcceptance {
  std::string golden_folder;
  AcceptedCore core;        ///< This program's.
  std::string why_not;      ///< As "3 of 99 scenarios do not agree, the first is ..."; empty: it is accepted.
  bool is_refused = false;  ///< Then nothing is written: --accept does not allow another class.
  CoreVerdict differences;  ///< From the one accepted before.
};

/// Of libraries_of(arguments). Plays each whole, unless its accepted core is this
/// program's already: then nothing is planned.
/// @param blessings of scenarios that will agree.
[[nodiscard]] std::vector<CoreAcceptance> plan_core_acceptances(const Core& core,
                                                                const std::vector<std::string>& arguments,
                                                                const std::vector<Blessing>& blessings,
                                                                const BlessOptions& options);

/// Writes those that are accepted, unless a blessing has failed.
/// ERRORS: as write_accepted_core's.
void write_cores(const std::vector<CoreAcceptance>& cores, const std::vector<Blessing>& blessings);

/// "core: accepted in golden/core", or why not. Complete lines.
[[nodiscard]] std::string acceptances_text(const std::vector<CoreAcceptance>& cores, bool is_written);

struct BlessReport {
  std::vector<Blessing> blessings;
  Pruning pruning;
  std::vector<CoreAcceptance> cores;
  bool is_written = false;
};

/// Why nothing is written, with the option that would allow it where there is one; empty: it is written.
[[nodiscard]] std::string refusal_sentence(const BlessReport& report);

/// Of a report that was written: that some, but not all of it was; else empty.
[[nodiscard]] std::string unfinished_sentence(const BlessReport& report);

/// What changes, old against new, by cause, and against the accepted cores. REQUIRES: the groups do not
/// outlive the report.
[[nodiscard]] std::vector<DifferenceGroup> groups_of(const BlessReport& report, CoreChecks& cores);

void print_plans(const Core& core, const BlessReport& report, const std::vector<DifferenceGroup>& groups,
                 const CoreChecks& cores, const Printing& printing);
/// What was written, or would be.
void print_done(const BlessReport& report, bool is_dry_run);
[[nodiscard]] Json bless_json(const BlessReport& report, const std::vector<DifferenceGroup>& groups);

}  // namespace hyrax
