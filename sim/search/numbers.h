// The numbers of a scenario as one list, and rounder ones in their place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "sim/scenario/scenario.h"

namespace hyrax {

using Number = std::variant<double*, std::int32_t*, std::uint64_t*>;

/// All real numbers, sizes and seeds, in the order of the file; frame numbers are none of them. They refer to
/// the scenario.
[[nodiscard]] std::vector<Number> numbers_of(Scenario& scenario);

/// Significant decimal digits of the shortest text of each number, in sum: 0 has none, 1e9 one.
[[nodiscard]] std::int64_t digits_of(const Scenario& scenario);

/// The longest a number can be.
inline constexpr int kDigitsMax = 17;

/// Rounds the number to so many significant decimal digits; 0 digits: to 0. A size or a seed is cut to its
/// leading digits.
void round_to(const Number& number, int digits);

}  // namespace hyrax
