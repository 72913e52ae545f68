// What a sample says, and how sure it is: bands, medians and shares with their intervals.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/result/figure.h"

namespace hyrax {

/// The quantile of a sample, 0 .. 1, between its neighbours where it falls between. REQUIRES: not empty.
[[nodiscard]] inline double quantile(std::vector<double> values, double part) {
  assert(!values.empty() && part >= 0.0 && part <= 1.0);
  std::sort(values.begin(), values.end());
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  if (values[below] == values[above]) return values[below];  // Both may be infinite.
  return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

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

/// A sample's median with its 95 % interval; NaN: not measured.
struct MedianEstimate {
  double median = kNotGiven;
  double low = kNotGiven;
  double high = kNotGiven;
};

/// The median with its 95 % interval: from the k-th smallest to the k-th largest value, which misses the
/// median of any distribution with a probability of 2 P(Binomial(n, 1/2) < k). Of fewer than 6 values it is
/// their range, which covers less: 1 - 2^(1 - n).
///
/// Source: W. R. Thompson, "On confidence ranges for the median and other expectation distributions for
/// populations of unknown distribution form", The Annals of Mathematical Statistics 7:122-128, 1936.
/// NaN of an empty sample. REQUIRES: at most 1,000 values.
[[nodiscard]] inline MedianEstimate median_of(std::vector<double> values) {
  assert(values.size() <= 1'000);
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  double term = std::ldexp(2.0, -static_cast<int>(values.size()));
  double missed = term;
  std::size_t ends = 0;  // k - 1.
  while (true) {
    term *= static_cast<double>(values.size() - ends) / static_cast<double>(ends + 1);
    if ((missed += term) > 0.05) break;
    ++ends;
  }
  const double low = values[ends], high = values[values.size() - 1 - ends];
  return {quantile(std::move(values), 0.5), low, high};
}

/// How many of a random sample have a property, with the 95 % interval of their share.
///
/// Source: E. B. Wilson, "Probable inference, the law of succession, and statistical inference", Journal of
/// the American Statistical Association 22:209-212, 1927. It is right near 0 and 1, too.
struct Share {
  std::int64_t count = 0;
  std::int64_t of = 0;

  void add(bool has_it) {
    ++of;
    if (has_it) ++count;
  }
  [[nodiscard]] double part() const { return static_cast<double>(count) / static_cast<double>(of); }
  [[nodiscard]] double low() const { return bound(-1.0); }
  [[nodiscard]] double high() const { return bound(1.0); }

 private:
  [[nodiscard]] double bound(double sign) const {
    if (of == 0) return sign < 0.0 ? 0.0 : 1.0;
    if (count == 0 && sign < 0.0) return 0.0;
    if (count == of && sign > 0.0) return 1.0;
    constexpr double kZ = 1.959963984540054;  // Standard normal quantile of 0.975.
    const auto n = static_cast<double>(of);
    const double centre = part() + kZ * kZ / (2.0 * n);
    const double half = kZ * std::sqrt(part() * (1.0 - part()) / n + kZ * kZ / (4.0 * n * n));
    return (centre + sign * half) / (1.0 + kZ * kZ / n);
  }
};

}  // namespace hyrax
