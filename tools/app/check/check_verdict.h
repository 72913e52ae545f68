// The verdict of `check` on one scenario, and which did not agree the last time.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sim/compare/expectations.h"
#include "sim/core/core.h"
#include "sim/trace/step_player.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/files/check_status.h"
#include "tools/store/output_guard.h"

namespace hyrax {

struct DifferenceGroup;

/// Its path is that of an unreferenced golden file without its suffix, if it is of one.
struct CheckVerdict : PairVerdict {
  CheckStatus status = CheckStatus::agreed;
  bool is_scenario = true;          ///< No golden file without a scenario, and no golden folder.
  bool has_golden = false;          ///< Its golden file exists.
  std::string golden_option;        ///< --golden as given; empty if it was not.
  std::vector<Expectation> broken;  ///< Expectations that do not hold.
  std::string non_finite;           ///< non_finite_text of the run; empty: it stays finite.
  /// Of the run of one without golden file; of an unreferenced golden file, as its summary states it.
  std::string state_hash;
  std::set<std::uint32_t> paths_taken;  ///< Of CheckOptions::watched_step.
  bool is_undecided = false;            ///< The golden file must be read.
  double seconds = 0.0;
  const DifferenceGroup* group = nullptr;  ///< In which its run differs, if it does; set by `explain`.
  /// The other half of a renamed scenario: of one whose golden file is missing the unreferenced golden file
  /// with its run, and the other way round. Set by `explain`.
  const CheckVerdict* renamed = nullptr;
};

struct CheckOptions {
  std::string golden_folder;
  bool reads_golden = true;  ///< If the summary does not decide. REQUIRES: no other threads.
  /// The program's, whose paths are noted as they are taken, which takes time; null: not noted.
  std::shared_ptr<const StepProgram> watched_step = nullptr;
};

/// Plays a scenario and compares; never throws Failure: it becomes a verdict.
[[nodiscard]] CheckVerdict check_scenario(const Core& core, const std::string& path,
                                          const CheckOptions& options);

/// A verdict for each golden file without a scenario, and for each golden folder that cannot be read; see
/// find_unreferenced.
[[nodiscard]] std::vector<CheckVerdict> unreferenced_verdicts(const std::vector<std::string>& arguments,
                                                              const std::string& golden_folder);

/// A file for each folder in which `check` is run, in $XDG_CACHE_HOME/hyrax-sim or ~/.cache/hyrax-sim.
/// Without these folders, or where they cannot be read or written, nothing is recorded.
class LastFailed {
 public:
  /// Reads what was recorded in the current folder.
  LastFailed();

  /// Whether the scenario, or golden file without one, did not agree.
  [[nodiscard]] bool contains(const std::string& path) const;
  /// Records the new verdicts; those of a folder that were not asked for this time are kept. Writes no file
  /// in a golden folder.
  void update(const std::vector<CheckVerdict>& verdicts, OutputGuard& guard);

 private:
  std::string file_;             // Empty: nothing is recorded.
  std::set<std::string> paths_;  // Absolute.
};

}  // namespace hyrax
