// The distance of two doubles in units in the last place.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

namespace hyrax {

/// How many representable doubles lie between a and b, plus one; 0 for equal values, +0 and -0
/// among them. Nothing where either is NaN.
[[nodiscard]] constexpr std::optional<std::uint64_t> ulps_between(double a, double b) {
  if (a != a || b != b) return std::nullopt;
  // Maps doubles to integers in the same order.
  const auto ordered = [](double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
    return (bits & kSign) != 0 ? kSign - (bits - kSign) : bits + kSign;
  };
  const std::uint64_t low = ordered(a);
  const std::uint64_t high = ordered(b);
  return low < high ? high - low : low - high;
}

}  // namespace hyrax
