// How many digits the numbers of a scenario have, and rounder ones in their place.
#pragma once

#include <cstdint>

#include "sim/scenario/numbers.h"

namespace hyrax {

/// Significant decimal digits of the shortest text of each number, in sum: 0 has none, 1e9 one.
[[nodiscard]] std::int64_t digits_of(const Scenario& scenario);

/// The longest a number can be.
inline constexpr int kDigitsMax = 17;

/// Rounds the number to so many significant decimal digits; 0 digits: to 0. A size or a seed is cut to its
/// leading digits.
void round_to(const NumberField& number, int digits);

}  // namespace hyrax
