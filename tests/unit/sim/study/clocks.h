// Clocks of studies, the same on every machine.
#pragma once

#include <cstdint>

namespace hyrax {

/// In ns; every piece of work takes the same time.
inline std::int64_t steady_ns() {
  static std::int64_t now_ns = 0;
  return now_ns += 100'000;
}

/// In ns; every piece of work takes longer than the one before.
inline std::int64_t unsteady_ns() {
  static std::int64_t now_ns = 0, tick_ns = 100'000;
  return now_ns += tick_ns += 1'000;
}

}  // namespace hyrax
