// The path of the sprite's centre, with as few points as a picture of a given scale needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/trajectory/columns.h"
#include "tools/report/sizes_in_force.h"

namespace hyrax {

struct PathPoint {
  double x_px = 0.0;
  double y_px = 0.0;
  double speed_px_per_s = 0.0;
};

enum class StrokeKind {
  flown,
  moved,       ///< By an input, or by a wall that moved.
  unrecorded,  ///< Between rows that are not consecutive, and too far apart to know the path.
};

/// One line without a break.
struct Stroke {
  StrokeKind kind = StrokeKind::flown;
  std::vector<PathPoint> points;
};

struct RunPath {
  std::vector<Stroke> strokes;
  /// At every frame whose number is a multiple of `frames_per_bead`; left out where they would overlap.
  std::vector<PathPoint> beads;
  std::int64_t frames_per_bead = 0;
  double speed_px_per_s_max = 0.0;
  /// If one throw is so fast that everything else would have the same colour: where the logarithmic colour
  /// scale begins; else 0.
  double speed_px_per_s_low = 0.0;
  std::optional<double> cut_at_s;  ///< The path is cut at this time, as it has too many points.
};

/// A path has no more points than this.
inline constexpr std::size_t kPathPointsMax = 1500;
inline constexpr std::size_t kBeadsMax = 200;

/// Leaves out rows closer than `detail_px` to the last one kept, and rows that are not finite. With too many
/// points left, the distance is up to eight times as large; a path that is still too long is cut.
[[nodiscard]] RunPath make_run_path(const Columns& rows, const SizesInForce& sizes, double detail_px);

}  // namespace hyrax
