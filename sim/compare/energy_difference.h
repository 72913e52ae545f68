// How far two runs are apart in energy.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/trajectory/row.h"

namespace hyrax {

/// The largest difference of the specific energy (vx² + vy²)/2 - G y of two rows, px²/s². Bounds that both
/// runs share add the same to each.
class EnergyDifference {
 public:
  explicit EnergyDifference(double gravity_px_per_s2) : gravity_px_per_s2_(gravity_px_per_s2) {}

  /// REQUIRES: rows of the same step, or of the same time.
  void add(const Row& a, const Row& b) {
    // Products of sums and differences: the difference of two large energies would lose digits.
    const double difference = 0.5 * ((b.vx_px_per_s - a.vx_px_per_s) * (b.vx_px_per_s + a.vx_px_per_s) +
                                     (b.vy_px_per_s - a.vy_px_per_s) * (b.vy_px_per_s + a.vy_px_per_s)) -
                              gravity_px_per_s2_ * (b.y_px - a.y_px);
    if (std::fabs(difference) > std::fabs(largest_ ? largest_->px2_per_s2 : 0.0))
      largest_ = {difference, a.step};
  }

  struct Largest {
    double px2_per_s2 = 0.0;  ///< Second run minus first.
    std::int64_t step = 0;    ///< Of the first run.
  };
  /// Nothing if no energy differs.
  [[nodiscard]] const std::optional<Largest>& largest() const { return largest_; }

 private:
  double gravity_px_per_s2_;
  std::optional<Largest> largest_;
};

}  // namespace hyrax
