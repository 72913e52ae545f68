// The recorded state after a frame.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace hyrax {

struct Row {
  std::int64_t step = 0;  ///< Row number: frame i makes row i + 1, row 0 is the start.
  double t_s = 0.0;
  double dt_s = 0.0;
  double x_px = 0.0;
  double y_px = 0.0;
  double vx_px_per_s = 0.0;
  double vy_px_per_s = 0.0;
  std::uint8_t contact = 0;  ///< Wall bits and kRestBit.
};

/// Equality of bits: +0 and -0 differ, a NaN equals itself.
[[nodiscard]] inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

[[nodiscard]] inline bool is_finite_state(const Row& row) {
  return std::isfinite(row.x_px) && std::isfinite(row.y_px) && std::isfinite(row.vx_px_per_s) &&
         std::isfinite(row.vy_px_per_s);
}

}  // namespace hyrax
