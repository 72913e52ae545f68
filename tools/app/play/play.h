// Plays a scenario for a command: with progress, its rows as they are asked for, or against a stored run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/compare/equal_times.h"
#include "sim/core/core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/run_summary.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// `replay` of a scenario, with progress on a terminal. The result does not depend on whether that is shown.
[[nodiscard]] RunSummary play_with_progress(const Core& core, const Scenario& scenario,
                                            std::vector<RowSink*> sinks, const ReplayOptions& options = {});

/// "first-fling: 600 steps, 10 s at 60 Hz".
[[nodiscard]] std::string title_of(const Scenario& scenario, std::int64_t steps, double simulated_s);

/// So many rows are played where no file holds them: a file of any origin may be of a far longer run.
inline constexpr std::int64_t kRowsPlayedMax = 20'000'000;

/// The first kRowsPlayedMax rows of a scenario's run. They are read once: copies share what is left.
[[nodiscard]] RowBatches played_rows(const Core& core, const Scenario& scenario);

/// The contacts of a whole run at these walls by its rows alone (contact_of_rows): which, and their steps.
[[nodiscard]] std::vector<Contact> contacts_by_rows(const TimedRun& run, const Scenario& scenario,
                                                    std::uint8_t walls);

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
