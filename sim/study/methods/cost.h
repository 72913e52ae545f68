// What pieces of work cost: in several processes, since what differs between these (where code, stack and
// heap lie) makes one of them faster or slower throughout; in each in rounds, every work once a round and in
// random order, so that a slow moment of the machine does not fall on one of them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/result/estimate.h"

namespace hyrax {

/// Does the work, and returns how long it took, in ns.
using Stopwatch = std::function<std::int64_t(const std::function<void()>& work)>;

/// The same short piece of arithmetic, again and again after each sample for as long as that took: shows how
/// steady the processor was.
struct ClockProbe {
  double median_ns = 0.0;
  double drift_rel = 0.0;  ///< (95th - 5th percentile) / median.

  /// Costs of a clock that drifts by more say more about the machine's other work than about the methods.
  static constexpr double kDriftMax_rel = 0.25;
  [[nodiscard]] bool is_steady() const { return drift_rel <= kDriftMax_rel; }
};

/// "not measured: clock unsteady", and if it was so as a whole " (drift 40 %, at most 25 %)".
[[nodiscard]] std::string unsteady_text(const ClockProbe& probe);

/// Time of one run of a piece of work.
struct Cost {
  std::vector<double> processes_ns = {};  ///< The median of each process; empty: not measured.
  MedianEstimate time_ns = {};            ///< median_of(processes_ns).

  [[nodiscard]] bool is_measured() const { return !processes_ns.empty(); }
};
[[nodiscard]] Cost cost_of(std::vector<double> processes_ns);

/// (work - part of it) / divisor, process by process. REQUIRES: of one measurement.
[[nodiscard]] Cost difference_of(const Cost& work, const Cost& part, double divisor = 1.0);

/// How many processes a rank takes. Of two works that cost the same, one is cheaper in all of n processes
/// with a probability of 2^(1 - n) (sign test, which assumes no distribution); with as many comparisons, that
/// one of them is ranked by chance has at most 5 % (Bonferroni; as all these p are equal, Holm's correction
/// is the same). At least 6, from which on median_of has its 95 %.
[[nodiscard]] int processes_for(std::int64_t comparisons);

/// Whether a is cheaper than b: in every process, of which there are processes_for(comparisons) or more.
/// Never of costs that are not measured. REQUIRES: of one measurement.
[[nodiscard]] bool is_cheaper(const Cost& a, const Cost& b, std::int64_t comparisons = 1);

struct CostOptions {
  int processes = processes_for(1);
  int rounds = 5;                   ///< In each, after some runs of each work to warm up.
  std::int64_t sample_ns = 50'000;  ///< A sample is as many runs as take this long.
  bool is_only = false;             ///< A study ends where its costs are measured.
};
inline constexpr std::uint64_t kOrderSeed = 1;  ///< Of the random orders.

using Works = std::vector<std::function<void()>>;

/// What one process measured.
struct ProcessTimes {
  std::vector<double> works_ns;  ///< The median of a work's samples; NaN: not measured.
  ClockProbe probe;              ///< After all samples.
};

/// Times all works in this process. A sample whose probe took longer than the median probe, by more than
/// ClockProbe::kDriftMax_rel, is left out; a work with fewer than half of its samples left is not measured.
/// @param process its number, which decides the orders.
[[nodiscard]] ProcessTimes time_works(const Works& works, const Stopwatch& time_of,
                                      const CostOptions& options, int process);

/// Times all works in CostOptions::processes processes, by time_works in each.
using CostMeter = std::function<std::vector<ProcessTimes>(const Works&, const CostOptions&)>;

struct Costs {
  std::vector<Cost> costs;  ///< In the order of the works: of those that every process measured.
  ClockProbe probe;         ///< Of the process that drifts most; if it is not steady, nothing is measured.
};
/// REQUIRES: times of the same works in all processes.
[[nodiscard]] Costs costs_of(const std::vector<ProcessTimes>& processes);

}  // namespace hyrax
