// The verdict of `check` on one scenario.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/trace/step_player.h"
#include "tools/app/causes/core_check.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/app/library/check_flow.h"
#include "tools/files/golden_place.h"

namespace hyrax {

struct CheckVerdict final : PairVerdict {
  std::set<std::uint32_t> paths_taken;  ///< Of CheckOptions::watched_step.
};

struct CheckOptions {
  std::string golden_folder;
  bool reads_golden = true;  ///< If the summary does not decide. REQUIRES: no other threads.
  /// The program's, whose paths are noted as they are taken, which takes time; null: not noted.
  std::shared_ptr<const StepProgram> watched_step = nullptr;
  bool draws = false;  ///< The run, for a sheet.
};

/// Plays a scenario and compares; never throws Failure: it becomes a verdict.
[[nodiscard]] CheckVerdict check_scenario(const Core& core, const std::string& path,
                                          const CheckOptions& options);

/// Of a golden file without a scenario, or a golden folder that cannot be read.
[[nodiscard]] CheckVerdict unreferenced_verdict(const UnreferencedGolden& golden);

// What is reported of them besides words.

[[nodiscard]] Json check_json(const CheckReport& report, const CoreChecks& cores);
/// The paths of the worst scenario of each of the first causes.
[[nodiscard]] std::vector<Figure> check_figures(const CheckReport& report);

}  // namespace hyrax
