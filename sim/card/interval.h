// Measurements with their intervals.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/result/share.h"
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

/// Before and after: of the base, of the candidate.
template <class Value>
struct BeforeAfter {
  Value before{};
  Value after{};
};

}  // namespace hyrax
