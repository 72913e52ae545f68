// SplitMix64, addressed by index: any draw of any seed without the ones before it.
#pragma once

#include <cstdint>

namespace hyrax {

/// Output k of seed s: mix(s + (k + 1) * golden gamma) modulo 2^64.
/// Source: G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators",
/// OOPSLA 2014, figure 14, with the finaliser constants of D. Stafford's variant 13.
constexpr std::uint64_t split_mix64(std::uint64_t seed, std::uint64_t k) {
  std::uint64_t z = seed + (k + 1) * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// u_k in [0, 1): the output's upper 53 bits, exactly representable.
constexpr double split_mix64_unit(std::uint64_t seed, std::uint64_t k) {
  return static_cast<double>(split_mix64(seed, k) >> 11) * 0x1p-53;
}

}  // namespace hyrax
