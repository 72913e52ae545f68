// From runs that differ to their causes: changes of one step that give the new bits in every row.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/explain/cause.h"
#include "sim/replay/kernel.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// A scenario whose run is not the golden file's.
struct DifferingRun {
  const StoredRun& golden;
  const StoredRun& fresh;       ///< The run of this program.
  std::string scenario_change;  ///< As "/start/vx_px_per_s 40000 -> 40001"; empty: both play the same.
  bool is_golden_as_blessed =
      true;  ///< Else somebody changed the golden file: its clock and inputs prove nothing.
};

/// Runs of one cause.
struct CauseGroup {
  Cause cause;
  std::vector<std::size_t> runs;  ///< By their index, in order.
};

/// Each run in one group. The base is the listing with the golden file's constants; it must give the golden
/// file's own bits. A candidate is one change of it: of the step, or the frame times or inputs of this
/// program; it reproduces a run if it gives the run's bits in every row, which a replay to the end decides.
/// The candidate that reproduces most of the runs makes the first group, and so on among the rest; of those
/// that reproduce equally many, that of the lowest TieRank, then the constant with the shortest decimal, then
/// the first. What none reproduces is of kind unknown; so is every run of a core that is not the paper's
/// model.
/// @param program the core that played the runs.
[[nodiscard]] std::vector<CauseGroup> explain(const std::vector<DifferingRun>& runs, const Kernel& program);

}  // namespace hyrax
