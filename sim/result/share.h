// A part of a random sample, with its uncertainty.
#pragma once

#include <cmath>
#include <cstdint>

namespace hyrax {

/// How many of a random sample have a property, with the 95 % interval of their share.
///
/// Source: E. B. Wilson, "Probable inference, the law of succession, and statistical inference", Journal of
/// the American Statistical Association 22:209-212, 1927. It is right near 0 and 1, too.
struct Share {
  std::int64_t count = 0;
  std::int64_t of = 0;

  [[nodiscard]] double low() const { return bound(-1.0); }
  [[nodiscard]] double high() const { return bound(1.0); }

 private:
  [[nodiscard]] double bound(double sign) const {
    if (of == 0) return sign < 0.0 ? 0.0 : 1.0;
    if (count == 0 && sign < 0.0) return 0.0;
    if (count == of && sign > 0.0) return 1.0;
    constexpr double kZ = 1.959963984540054;  // Standard normal quantile of 0.975.
    const auto n = static_cast<double>(of);
    const double part = static_cast<double>(count) / n;
    const double centre = part + kZ * kZ / (2.0 * n);
    const double half = kZ * std::sqrt(part * (1.0 - part) / n + kZ * kZ / (4.0 * n * n));
    return (centre + sign * half) / (1.0 + kZ * kZ / n);
  }
};

}  // namespace hyrax
