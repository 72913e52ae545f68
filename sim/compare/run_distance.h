// How far two runs are apart, gathered row by row.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/trajectory/row.h"

namespace hyrax {

/// Where two runs are farthest apart.
struct WorstDistance {
  double px = 0.0;        ///< hypot(dx, dy); infinite where it is not a number.
  std::int64_t step = 0;  ///< The first row of that distance; at equal times the first run's, up to the time.
  double t_s = 0.0;       ///< In the first run.
};

/// How far two runs are apart: the largest distance of two rows of one step where each frame that both have
/// has the same dt, to the bit; else the largest at equal times (equal_times.h).
struct Distance {
  std::optional<WorstDistance> largest = {};  ///< Nothing if no position differs, in the rows that are known.
  bool is_at_equal_times = false;
  std::int64_t frames_left_out = 0;  ///< At equal times, frames of place, grab, release or resize.
  bool has_unknown_rows = false;     ///< That no file holds and no core plays again.
  std::int64_t rows_max = 0;         ///< Only so many were compared; 0: all.

  [[nodiscard]] double px() const { return largest ? largest->px : 0.0; }
};

/// The one that is farther, the earlier where both are as far.
inline void take_larger(std::optional<WorstDistance>& largest, const WorstDistance& found) {
  if (found.px > (largest ? largest->px : 0.0)) largest = found;
}

/// Distance in px of two positions; 0 for equal bits, infinite where it is not a number.
[[nodiscard]] double distance_px(const State& a, const State& b);

/// Gathers what the class of a difference depends on, apart from the contacts' steps, and the distance by
/// steps.
class RunDistance {
 public:
  /// @param other_walls that are not compared, as a contact byte.
  explicit RunDistance(int other_walls = 0)
      : walls_(~(other_walls | ((other_walls & static_cast<int>(Wall::ground)) != 0 ? kRestBit : 0))) {}

  /// REQUIRES: rows of the same step.
  void add(const Row& a, const Row& b);
  /// The quantities of one contact in both runs, for runs whose rows are equal.
  void add(const Contact& a, const Contact& b);
  /// A row that is known of one run only.
  void add_unknown() { is_rounding_ = false; }

  /// Of two rows of one step; nothing if no position differs.
  [[nodiscard]] const std::optional<WorstDistance>& largest() const { return largest_; }
  /// Whether a frame of one has another dt than that of the other: then rows of one step are of other times.
  [[nodiscard]] bool has_other_dt() const { return has_other_dt_; }
  /// Whether a wall clamped in one run and not in the other.
  [[nodiscard]] bool has_other_walls() const { return has_other_walls_; }
  /// Whether every row is within rounding: the same contact byte, positions within 1e-6 px, velocities within
  /// 1e-6 px/s + 1e-12 of their size, t and dt within 1e-9 s. A NaN is within nothing.
  [[nodiscard]] bool is_rounding() const { return is_rounding_; }

 private:
  int walls_;  // And the rest bit.
  std::optional<WorstDistance> largest_;
  bool has_other_dt_ = false;
  bool has_other_walls_ = false;
  bool is_rounding_ = true;
};

/// The largest difference of the specific energy (vx² + vy²)/2 - G y of two rows, px²/s². Bounds that both
/// runs share add the same to each.
class EnergyDifference {
 public:
  explicit EnergyDifference(double gravity_px_per_s2) : gravity_px_per_s2_(gravity_px_per_s2) {}

  /// REQUIRES: rows of the same step.
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
    std::int64_t step = 0;
  };
  /// Nothing if no energy differs.
  [[nodiscard]] const std::optional<Largest>& largest() const { return largest_; }

 private:
  double gravity_px_per_s2_;
  std::optional<Largest> largest_;
};

}  // namespace hyrax
