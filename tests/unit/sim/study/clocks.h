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

/// Measures by such a clock; all processes are this one. No work sets it forward: each is done once.
template <std::int64_t (*kNow_ns)()>
std::vector<ProcessTimes> metered(const Works& works, const CostOptions& options) {
  const auto time_of = [](const std::function<void()>&) {
    const std::int64_t from_ns = kNow_ns();
    return kNow_ns() - from_ns;
  };
  std::vector<ProcessTimes> times{time_works(works, time_of, options, 0)};
  const Works done(works.size(), [] {});
  while (std::ssize(times) < options.processes)
    times.push_back(time_works(done, time_of, options, static_cast<int>(std::ssize(times))));
  return times;
}

}  // namespace hyrax
