// How far two runs are apart, gathered row by row.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/trajectory/row.h"

namespace hyrax {

/// The largest distance of two rows of the same step.
struct WorstDistance {
  double px = 0.0;        ///< hypot(dx, dy); infinite where it is not a number.
  std::int64_t step = 0;  ///< The first row of that distance.
};

/// Distance in px of two positions; 0 for equal bits, infinite where it is not a number.
[[nodiscard]] double distance_px(const State& a, const State& b);

/// Gathers what the class of a difference depends on, apart from the contacts' steps.
class RunDistance {
 public:
  /// REQUIRES: rows of the same step.
  void add(const Row& a, const Row& b);
  /// The quantities of one contact in both runs, for runs whose rows are equal.
  void add(const Contact& a, const Contact& b);
  /// A row that is known of one run only.
  void add_unknown() { is_rounding_ = false; }

  /// Nothing if no position differs.
  [[nodiscard]] const std::optional<WorstDistance>& largest() const { return largest_; }
  /// Whether a wall clamped in one run and not in the other.
  [[nodiscard]] bool has_other_walls() const { return has_other_walls_; }
  /// Whether every row is within rounding: the same contact byte, positions within 1e-6 px, velocities within
  /// 1e-6 px/s + 1e-12 of their size, t and dt within 1e-9 s. A NaN is within nothing.
  [[nodiscard]] bool is_rounding() const { return is_rounding_; }

 private:
  std::optional<WorstDistance> largest_;
  bool has_other_walls_ = false;
  bool is_rounding_ = true;
};

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
