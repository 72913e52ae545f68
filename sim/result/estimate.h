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

/// The median with its bootstrap interval (percentile method). The bootstrap distribution of a median is
/// known, so that nothing is drawn: with n = 2 m + 1 values, P(median of a resample <= the k-th smallest) =
/// P(Binomial(n, k / n) >= m + 1). Of an even number of values the interval is a little wider than that.
///
/// Source: B. Efron, "Bootstrap methods: another look at the jackknife", The Annals of Statistics 7:1-26,
/// 1979, section 3. NaN of an empty sample. REQUIRES: at most 1,000 values.
[[nodiscard]] inline MedianEstimate median_of(std::vector<double> values) {
  assert(values.size() <= 1'000);
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at_least = [n = values.size()](std::size_t count, double part) {
    double sum = 0.0;
    double term = std::pow(1.0 - part, static_cast<double>(n));  // P(Binomial(n, part) = 0).
    for (std::size_t k = 0; k < count; ++k) {
      sum += term;
      term *= static_cast<double>(n - k) / static_cast<double>(k + 1) * part / (1.0 - part);
    }
    return 1.0 - sum;
  };
  const auto n = static_cast<double>(values.size());
  std::size_t below = 1;  // The low end is the below-th smallest value.
  while (below < values.size() && at_least((values.size() + 1) / 2, static_cast<double>(below) / n) <= 0.025)
    ++below;
  const double low = values[below - 1];
  const double high = values[values.size() - below];
  return {quantile(std::move(values), 0.5), std::min(low, high), std::max(low, high)};
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
