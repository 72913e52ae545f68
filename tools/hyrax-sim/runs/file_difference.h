// Two trajectory files, compared row by row.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/compare/trajectory_comparer.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {

struct FileDifference {
  Comparison comparison;
  TrajectoryComparer values;
  std::int64_t rows_compared = 0;
  std::optional<std::int64_t> lone_step;  ///< Of the first row that only one of the files holds.
};

/// Compares what both files record. Memory does not grow with the rows.
[[nodiscard]] FileDifference compare_files(const TrajectoryFile& a, const TrajectoryFile& b,
                                           const Tolerance& tolerance);

}  // namespace hyrax
