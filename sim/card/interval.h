// Measurements with their intervals.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/study/methods/cost.h"

namespace hyrax {

/// Of a sample: its median, and where the middle 80 % of it are.
struct Band {
  std::int64_t samples = 0;
  double median = 0.0;
  double low = 0.0;   ///< 10 %.
  double high = 0.0;  ///< 90 %.
};

/// Nothing of an empty sample.
[[nodiscard]] inline std::optional<Band> band_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return Band{static_cast<std::int64_t>(values.size()), quantile(values, 0.5), quantile(values, 0.1),
              quantile(values, 0.9)};
}

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

/// Before and after: of the base, of the candidate.
template <class Value>
struct BeforeAfter {
  Value before{};
  Value after{};
};

}  // namespace hyrax
