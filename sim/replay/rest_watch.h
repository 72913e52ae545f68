// Since when the sprite has stayed in its place.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/scenario/timeline.h"

namespace hyrax {

/// Judges rest by position, never by vy: on most displays the speed of a sprite that stands on the
/// floor never becomes 0. Keeps an anchor, row 0 at first; a row whose x or y is more than 0.5 px
/// from the anchor's becomes the anchor.
class RestWatch {
 public:
  static constexpr double kStill_px = 0.5;
  static constexpr double kLeastRest_s = 1.0;

  RestWatch(double x_px, double y_px, double t_s) : x_px_(x_px), y_px_(y_px), t_s_(t_s) {}

  [[nodiscard]] bool is_moved(double x_px, double y_px) const {
    return std::fabs(x_px - x_px_) > kStill_px || std::fabs(y_px - y_px_) > kStill_px;
  }
  void move(double x_px, double y_px, double t_s) {
    x_px_ = x_px;
    y_px_ = y_px;
    t_s_ = t_s;
  }
  void set_time(double t_s) { t_s_ = t_s; }

  /// t in s of the anchor, if the last row is at least a second later.
  [[nodiscard]] std::optional<double> at_rest_since_s(double t_end_s) const {
    if (t_end_s - t_s_ >= kLeastRest_s) return t_s_;
    return std::nullopt;
  }

 private:
  double x_px_;
  double y_px_;
  double t_s_;
};

}  // namespace hyrax
