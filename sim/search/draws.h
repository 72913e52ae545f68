// Numbers drawn from a seed, one after another.
#pragma once

#include <cassert>
#include <cstdint>
#include <iterator>

#include "sim/scenario/split_mix64.h"

namespace hyrax {

/// Draws of SplitMix64 in order of their index; the same on every machine.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}

  [[nodiscard]] std::uint64_t bits() { return split_mix64(seed_, k_++); }
  /// 0 .. end - 1. REQUIRES: end > 0.
  [[nodiscard]] std::uint64_t below(std::uint64_t end) {
    assert(end > 0);
    return bits() % end;
  }
  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * split_mix64_unit(seed_, k_++);
  }
  /// True once in `times`. REQUIRES: times > 0.
  [[nodiscard]] bool once_in(std::uint64_t times) { return below(times) == 0; }
  template <class Values>
  [[nodiscard]] const auto& one_of(const Values& values) {
    return values[below(std::size(values))];
  }

 private:
  std::uint64_t seed_;
  std::uint64_t k_ = 0;
};

}  // namespace hyrax
