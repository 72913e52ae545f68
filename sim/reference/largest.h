// The largest of values as they come in. A NaN stays: what was not a number once is not measured.
#pragma once

#include <cmath>

namespace hyrax {

/// The larger of both; NaN if either is. (std::max drops a NaN on its right.)
constexpr double larger(double a, double b) { return b > a || b != b ? b : a; }

/// The largest of many distances; the root is taken once.
class LargestDistance {
 public:
  void add(double dx, double dy) {
    const double squared = dx * dx + dy * dy;
    if (!(squared > squared_) && squared == squared) return;
    squared_ = squared;
    dx_ = dx;
    dy_ = dy;
  }
  /// hypot(dx, dy), which may exceed the root of the largest double; NaN if any was.
  [[nodiscard]] double value() const {
    // Where the square has neither lost digits nor run over; or is NaN.
    if (!(squared_ <= 1e-280 || squared_ >= 1e280)) return std::sqrt(squared_);
    const double scale = larger(std::fabs(dx_), std::fabs(dy_));
    if (scale == 0.0) return 0.0;
    const double dx = dx_ / scale;
    const double dy = dy_ / scale;
    return scale * std::sqrt(dx * dx + dy * dy);
  }

 private:
  double squared_ = 0.0;
  double dx_ = 0.0;
  double dy_ = 0.0;
};

/// hypot(dx, dy).
[[nodiscard]] inline double distance(double dx, double dy) {
  LargestDistance one;
  one.add(dx, dy);
  return one.value();
}

}  // namespace hyrax
