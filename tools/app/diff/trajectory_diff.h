// Two trajectory files, compared row by row.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/compare/overlay.h"
#include "sim/compare/run_distance.h"
#include "sim/compare/trajectory_comparer.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {

/// How a file's run ended.
struct RunEnd {
  Row row;
  bool has_every_row = false;  ///< Else it is not known when it settled.
  std::optional<double> settled_since_s;
  std::int64_t contacts_total = 0;  ///< With those that are not recorded.
};

struct TrajectoryDiff {
  explicit TrajectoryDiff(const Tolerance& tolerance) : values(tolerance) {}

  bool is_by_time = false;  ///< Distances of rows of the same time: the clocks differ.
  Comparison comparison;
  TrajectoryComparer values;
  std::optional<EnergyDifference> energy;  ///< Of the paper's model.
  std::int64_t rows_compared = 0;          ///< Of the same step.
  std::optional<double> largest_at_s;
  RunEnd end_a;
  RunEnd end_b;

  /// Whether anything that is recorded differs, within the tolerance or not.
  [[nodiscard]] bool has_differences() const;
};

/// @param overlay gets the pairs whose distance counts; may be nullptr.
[[nodiscard]] TrajectoryDiff diff_trajectories(const TrajectoryFile& a, const TrajectoryFile& b,
                                               const Tolerance& tolerance, Overlay* overlay);

}  // namespace hyrax
