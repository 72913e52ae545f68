// The timer that studies are handed.
#pragma once

#include <chrono>
#include <cstdint>

namespace hyrax {

[[nodiscard]] inline std::int64_t steady_clock_ns() {
  using std::chrono::steady_clock;
  return std::chrono::duration_cast<std::chrono::nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace hyrax
