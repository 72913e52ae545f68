// Times pieces of work side by side: round by round, each once, so that a slow moment of the
// machine falls on all of them.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace hyrax::bench {

/// Seconds of one piece of work over all rounds, sorted.
struct Timing {
  std::vector<double> seconds;
  [[nodiscard]] double quantile(double part) const {
    return seconds[static_cast<std::size_t>(part * static_cast<double>(seconds.size() - 1) + 0.5)];
  }
  [[nodiscard]] double median() const { return quantile(0.5); }
};

/// One warm-up and `rounds` timed rounds of every piece of work.
inline std::vector<Timing> time_side_by_side(const std::vector<std::function<void()>>& works, int rounds) {
  std::vector<Timing> timings(works.size());
  for (int round = -1; round < rounds; ++round)
    for (std::size_t index = 0; index < works.size(); ++index) {
      const auto start = std::chrono::steady_clock::now();
      works[index]();
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      if (round >= 0) timings[index].seconds.push_back(elapsed.count());
    }
  for (Timing& timing : timings) std::sort(timing.seconds.begin(), timing.seconds.end());
  return timings;
}

/// Keeps the compiler from removing work whose result is unused.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "r,m"(value) : "memory");
}

}  // namespace hyrax::bench
