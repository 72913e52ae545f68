// Two trajectory files, compared row by row.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/compare/overlay.h"
#include "sim/compare/run_distance.h"
#include "sim/compare/trajectory_comparer.h"
#include "sim/core/core.h"
#include "tools/files/json.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {

struct TrajectoryDiff {
  explicit TrajectoryDiff(const Tolerance& tolerance, int other_walls = 0) : values(tolerance, other_walls) {}

  Comparison comparison;
  TrajectoryComparer values;
  std::optional<EnergyDifference> energy;  ///< Of the paper's model, where rows of one step are of one time.
  std::int64_t rows_compared = 0;          ///< Of the same step.
  std::int64_t contacts_total_a = 0, contacts_total_b = 0;  ///< With those that are not recorded.

  /// Whether anything that is recorded differs, within the tolerance or not.
  [[nodiscard]] bool has_differences() const;
};

/// @param core plays the rows that a file does not hold, where that gives its state hash.
/// @param overlay gets the pairs whose distance counts; may be nullptr.
[[nodiscard]] TrajectoryDiff diff_trajectories(const Core& core, const TrajectoryFile& a,
                                               const TrajectoryFile& b, const Tolerance& tolerance,
                                               Overlay* overlay);

/// comparison_text, energy, the worst value of each field, and which build settings of the programs that made
/// the files differ, with what that usually means for a difference of that class. Complete lines, indented by
/// two; of files without a difference the build settings only, if `lists_all`.
[[nodiscard]] std::string diff_text(const TrajectoryDiff& diff, const Provenance& a, const Provenance& b,
                                    bool lists_all);

/// {"agree", "class", "max_px", ..., "worst", "contacts"}
[[nodiscard]] Json diff_json(const TrajectoryDiff& diff);

}  // namespace hyrax
