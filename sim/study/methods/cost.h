// What pieces of work cost: in rounds, each work once a round and in random order, so that a slow moment of
// the machine does not fall on one of them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/result/estimate.h"

namespace hyrax {

/// Nanoseconds on a clock that never goes back.
using NanosecondClock = std::function<std::int64_t()>;

/// Time of one run of a piece of work.
struct Cost {
  std::vector<double> rounds_ns = {};  ///< A sample a round, in their order; empty: not measured.
  MedianEstimate time_ns = {};         ///< median_of(rounds_ns).

  [[nodiscard]] bool is_measured() const { return !rounds_ns.empty(); }
};
[[nodiscard]] Cost cost_of(std::vector<double> rounds_ns);

/// (work - part of it) / divisor, round by round. REQUIRES: of one measurement.
[[nodiscard]] Cost difference_of(const Cost& work, const Cost& part, double divisor = 1.0);

/// Whether a is cheaper than b beyond the noise: the 95 % interval of a / b, round by round, is below 1.
/// Never of costs that are not measured. REQUIRES: of one measurement.
[[nodiscard]] bool is_cheaper(const Cost& a, const Cost& b);

/// The same short piece of arithmetic, timed between the samples: shows how steady the processor's clock was.
struct ClockProbe {
  double median_ns = 0.0;
  double drift_rel = 0.0;  ///< (95th - 5th percentile) / median.

  /// Costs of a clock that drifts by more say more about the machine's other work than about the methods.
  static constexpr double kDriftMax_rel = 0.25;
  [[nodiscard]] bool is_steady() const { return drift_rel <= kDriftMax_rel; }
};

/// "not measured: clock unsteady (drift 40 %, at most 25 %)"; empty if it is steady.
[[nodiscard]] std::string unsteady_text(const ClockProbe& probe);

struct CostOptions {
  int repetitions = 21;             ///< Rounds, after one run of each work to warm up.
  std::int64_t sample_ns = 50'000;  ///< A sample is as many runs as take this long.
};

struct Costs {
  std::vector<Cost> costs;  ///< In the order of the works; none is measured if the clock was not steady.
  ClockProbe probe;
};

/// Times all works. `report_progress`, if it is set, is called with the number of samples done and of all.
[[nodiscard]] Costs measure_costs(
    const std::vector<std::function<void()>>& works, const NanosecondClock& now_ns,
    const CostOptions& options, const std::function<void(std::int64_t, std::int64_t)>& report_progress = {});

}  // namespace hyrax
