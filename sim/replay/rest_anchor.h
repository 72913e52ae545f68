// Since when the sprite has stayed in its place.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

namespace hyrax {

/// Judges rest by position, never by vy: on most displays the speed of a sprite that stands on the
/// floor never becomes 0. Row 0 is the anchor at first; a row whose x or y is more than 0.5 px from
/// the anchor's becomes the anchor.
struct RestAnchor {
  static constexpr double kStill_px = 0.5;
  static constexpr double kLeastRest_s = 1.0;

  double x_px = 0.0;
  double y_px = 0.0;
  double t_s = 0.0;

  /// Whether a row so far away becomes the anchor; then it does, but for its time.
  bool moves_to(double row_x_px, double row_y_px) {
    if (!(std::fabs(row_x_px - x_px) > kStill_px) && !(std::fabs(row_y_px - y_px) > kStill_px)) return false;
    x_px = row_x_px;
    y_px = row_y_px;
    return true;
  }

  /// t in s of the anchor, if the last row is at least a second later.
  [[nodiscard]] std::optional<double> at_rest_since_s(double t_end_s) const {
    if (t_end_s - t_s >= kLeastRest_s) return t_s;
    return std::nullopt;
  }
};

}  // namespace hyrax
