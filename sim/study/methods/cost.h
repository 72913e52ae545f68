// What pieces of work cost, in random order so that a slow moment of the machine does not fall on one of
// them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace hyrax {

/// Nanoseconds on a clock that never goes back.
using NanosecondClock = std::function<std::int64_t()>;

/// Time of one run of a piece of work, over the repetitions.
struct Cost {
  double median_ns = 0.0;
  double lower_quartile_ns = 0.0;
  double upper_quartile_ns = 0.0;
};

/// The same short piece of arithmetic, timed between the samples: shows how steady the processor's clock was.
struct ClockProbe {
  double median_ns = 0.0;
  double drift_rel = 0.0;  ///< (95th - 5th percentile) / median.
};

struct CostOptions {
  int repetitions = 20;             ///< Samples of each piece of work, after one run to warm up.
  std::int64_t sample_ns = 50'000;  ///< A sample is as many runs as take this long.
  std::uint64_t seed = 1;           ///< Of the order of the samples.
};

struct Costs {
  std::vector<Cost> costs;  ///< In the order of the works.
  ClockProbe probe;
};

/// Times all works, samples in random order. `report_progress`, if it is set, is called with the number of
/// samples done and of all.
[[nodiscard]] Costs measure_costs(
    const std::vector<std::function<void()>>& works, const NanosecondClock& now_ns,
    const CostOptions& options, const std::function<void(std::int64_t, std::int64_t)>& report_progress = {});

/// The quantile of a sample, 0 .. 1, between its neighbours where it falls between. REQUIRES: not empty.
[[nodiscard]] double quantile(std::vector<double> values, double part);

}  // namespace hyrax
