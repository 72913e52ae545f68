// The verdict of `check` on one scenario.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/trace/step_player.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/files/unreferenced_golden.h"

namespace hyrax {

struct DifferenceGroup;

/// Its path is that of an unreferenced golden file without its suffix, if it is of one. The state hash is
/// that of the run of one without golden file; of an unreferenced golden file, as its summary states it.
struct CheckVerdict : PairVerdict {
  std::string golden_option;               ///< --golden as given; empty if it was not.
  std::string non_finite;                  ///< non_finite_text of the run; empty: it stays finite.
  std::set<std::uint32_t> paths_taken;     ///< Of CheckOptions::watched_step.
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

/// Of a golden file without a scenario, or a golden folder that cannot be read.
[[nodiscard]] CheckVerdict unreferenced_verdict(const UnreferencedGolden& golden);

}  // namespace hyrax
