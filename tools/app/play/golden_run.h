// A scenario's run, compared with a stored one.
#pragma once

#include <vector>

#include "sim/compare/comparison.h"
#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/run_summary.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// A run by the core, compared with the stored one.
struct ComparedRun {
  Comparison comparison{};
  RunSummary summary;
};
/// @param restoring cores of which one, or this one, may have played the stored run: they restore rows that
/// it keeps as blocks, where they give its digests.
[[nodiscard]] ComparedRun compare_with(const Core& core, const StoredRun& kept, const Scenario& scenario,
                                       std::vector<Core> restoring = {});

/// Whether the stored run's own scenario gives its rows and contacts. False where that would take too long to
/// find out.
[[nodiscard]] bool gives_its_rows(const Core& core, const StoredRun& kept);

/// Plays the scenario and keeps the contents of a golden file. Memory does not grow with the contacts: if
/// they are many, the run replays them on demand.
struct FreshRun {
  StoredRun run;
  RunSummary summary;
};
/// @param recording plays the run: the core, or it watched; what is replayed on demand is by the core itself.
[[nodiscard]] FreshRun play_for_golden(const Core& core, const Scenario& scenario, const Core& recording);

}  // namespace hyrax
