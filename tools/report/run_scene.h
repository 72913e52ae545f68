// What a picture of a run shows, in px of its window, without drawing it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/columns.h"
#include "sim/trajectory/contact.h"
#include "tools/report/run_path.h"
#include "tools/report/throws.h"

namespace hyrax {

struct Box {
  double left_px = 0.0, top_px = 0.0, right_px = 0.0, bottom_px = 0.0;

  [[nodiscard]] double width_px() const { return right_px - left_px; }
  [[nodiscard]] double height_px() const { return bottom_px - top_px; }
  /// Whether the point is inside; false if it is not finite.
  [[nodiscard]] bool holds(double x_px, double y_px) const {
    return x_px >= left_px && x_px <= right_px && y_px >= top_px && y_px <= bottom_px;
  }
};

/// Whether two outlines differ by less than `tolerance` times the sides of the first.
[[nodiscard]] bool nearly_cover(const Box& a, const Box& b, double tolerance);

/// The sprite's outline at a moment.
[[nodiscard]] Box sprite_box(double x_px, double y_px, const Size& sprite);

struct Bounce {
  Wall wall = Wall::ground;
  Box sprite;
};

struct RunScene {
  std::vector<Size> windows;  ///< Each once, in order; of many some, with the first and the last.
  std::optional<Box> start, end;
  std::optional<PathPoint> not_finite;  ///< Centre before the row that is not finite, if that is in view.
  std::vector<Bounce> bounces;          ///< The first kBouncesShownMax.
  std::vector<Box> ghosts;              ///< Their outlines, without those that nearly cover one another.
  WallCounts contacts{};                ///< How many there are, drawn or not.
  std::vector<Throw> throws;            ///< The first kThrowsShownMax.
  std::vector<TimedInput> inputs;       ///< The first kInputsLabelledMax.
  RunPath path;
  Box view;  ///< Contains the windows, and the sprite while it is near them.
};

inline constexpr std::size_t kBouncesShownMax = 30;
inline constexpr std::size_t kThrowsShownMax = 12;
inline constexpr std::size_t kInputsLabelledMax = 12;
inline constexpr std::size_t kWindowsShownMax = 12;

/// @param view_parts the resolution: the path shows details larger than the view's longer side divided by it.
/// REQUIRES: rows and contacts are of this scenario, whose events have frames.
[[nodiscard]] RunScene make_run_scene(const Scenario& scenario, const Columns& rows,
                                      const std::vector<Contact>& contacts, double view_parts);

}  // namespace hyrax
