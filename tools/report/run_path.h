// The way of the sprite's centre, with as few points as a picture of a given scale can show.
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
  unrecorded,  ///< Between rows that are not consecutive, and too far apart to tell the way.
};

/// One line without a break.
struct Stroke {
  StrokeKind kind = StrokeKind::flown;
  std::vector<PathPoint> points;
};

struct RunPath {
  std::vector<Stroke> strokes;
  /// Flown to in every frame whose number is a multiple of `frames_per_bead`; none where they would crowd.
  std::vector<PathPoint> beads;
  std::int64_t frames_per_bead = 0;
  double speed_px_per_s_max = 0.0;
  /// Where one throw is so fast that all else would have one colour, colours are logarithmic from here on;
  /// else 0.
  double speed_px_per_s_low = 0.0;
  std::optional<double> cut_at_s;  ///< The path goes on after this moment: there was no room for more.
};

/// A path has no more points than this.
inline constexpr std::size_t kPathPointsMax = 1500;
inline constexpr std::size_t kBeadsMax = 200;

/// Leaves out rows that lie closer than `detail_px` to the last one kept, and rows that are not
/// finite. Where too many are left, it leaves out up to eight times as coarsely; what is too long
/// even so is cut.
[[nodiscard]] RunPath make_run_path(const Columns& rows, const SizesInForce& sizes, double detail_px);

}  // namespace hyrax
