// Clocks of studies, the same on every machine.
#pragma once

#include <cstdint>

#include "sim/scenario/split_mix64.h"
#include "sim/study/methods/cost.h"

namespace hyrax {

/// In ns; every piece of work takes the same time.
inline std::int64_t steady_ns() {
  static std::int64_t now_ns = 0;
  return now_ns += 100'000;
}

/// In ns; work takes up to four times as long as at other times.
inline std::int64_t unsteady_ns() {
  static std::int64_t now_ns = 0;
  static std::uint64_t draws = 0;
  return now_ns += 100'000 + static_cast<std::int64_t>(split_mix64(1, ++draws) % 300'000);
}

/// Measures by such a clock; all processes are this one.
template <std::int64_t (*kNow_ns)()>
std::vector<ProcessTimes> metered(const Works& works, const CostOptions& options) {
  const auto time_of = [](const std::function<void()>& work) {
    const std::int64_t from_ns = kNow_ns();
    work();
    return kNow_ns() - from_ns;
  };
  std::vector<ProcessTimes> times;
  for (int process = 0; process < options.processes; ++process)
    times.push_back(time_works(works, time_of, options, process));
  return times;
}

}  // namespace hyrax
