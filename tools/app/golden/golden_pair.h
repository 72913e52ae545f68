// A scenario's run against its golden pair: the .h5 file and the summary beside it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim/core/core.h"
#include "sim/trajectory/stored_run.h"
#include "tools/app/library/scenario_verdict.h"
#include "tools/app/play/play.h"

namespace hyrax {

/// Both runs of a pair that differ, for what is to be explained.
struct PairRuns {
  StoredRun golden;
  StoredRun fresh;                   ///< The run of this program.
  bool is_golden_as_blessed = true;  ///< The .h5 file has the checksum in its summary.
  std::string core;                  ///< The core that the summary names; empty: written before 0.2.
  bool is_repeated = true;           ///< The run was played twice, and the bits were the same.
};

struct PairComparison : ComparedRun {
  bool is_proved = true;  ///< By the checksums of the summary, which say that nothing else differs.
  /// A pair that agrees, as it was blessed, under the same name: nothing of it is to be written.
  bool is_kept = false;
  /// For a pair that agrees: a note if the bytes of its .h5 file do not have the checksum in the summary.
  std::string note{};
  bool gives_its_rows = true;  ///< False: the scenario in the .h5 file was changed since it was blessed.
  /// Where rows, contacts, scenarios or two plays differ; nullptr where the pair agrees or the golden file
  /// was changed.
  std::shared_ptr<const PairRuns> runs{};
};

/// What a command found of a scenario and its golden pair, whatever it does with it.
struct PairVerdict : PairComparison, ScenarioVerdict {
  [[nodiscard]] bool differs() const override { return !comparison.agrees; }
  [[nodiscard]] Deviation deviation() const override;
  [[nodiscard]] std::string consequence() const override;
  [[nodiscard]] std::string first_difference() const override;
  [[nodiscard]] std::string differences_text(bool lists_all) const override;
  [[nodiscard]] Json::Object differences_json() const override;
};

/// The one verdict on a golden pair, whichever command asks for it. The .h5 file is read only where the
/// checksums of the summary do not prove that it agrees.
/// @param reads_h5 whether it may be read; if not, nothing is returned where it would have to be.
/// @param recording plays the scenario once: the core, or it watched.
/// REQUIRES: the .h5 file exists (without its .txt the pair never agrees); with `reads_h5`, as read_isolated.
/// ERRORS: as read_golden's; Failure(cannot_access) where a file of the pair cannot be read.
[[nodiscard]] std::optional<PairComparison> compare_with_pair(const Core& core, const Scenario& scenario,
                                                              const GoldenPlace& place, bool reads_h5,
                                                              const Core& recording);

/// Whether the .h5 file need not be written again when the scenario is blessed: it says all that a new one
/// would, its provenance aside, whatever the summary says.
/// REQUIRES, ERRORS: as compare_with_pair's with `reads_h5`.
[[nodiscard]] bool is_h5_current(const Core& core, const Scenario& scenario, const GoldenPlace& place);

/// The summary that is blessed with a run of this program's core.
/// @param h5_checksum file_checksum of the .h5 file. @param core_name that the summary names.
[[nodiscard]] std::string summary_of(const Core& core, const FreshRun& fresh, const std::string& reason,
                                     const std::string& h5_checksum, const std::string& core_name);

/// The summary of a pair that agrees as it is written now, with its own reason and core.
[[nodiscard]] std::string renewed_summary(const Core& core, const Scenario& scenario,
                                          const GoldenPlace& place);

}  // namespace hyrax
