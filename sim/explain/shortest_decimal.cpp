#include <fmt/format.h>

#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

#include "sim/explain/fitted_constant.h"

namespace hyrax {
namespace {

double number_of(const std::string& text) {
  double number = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

// The least number of so many significant digits that is at least `low`, which is positive.
double rounded_up(double low, int digits) {
  const std::string text = fmt::format("{:.{}e}", low, digits - 1);
  const double nearest = number_of(text);
  if (nearest >= low) return nearest;
  const std::size_t exponent_at = text.find('e');
  std::string mantissa = text.substr(0, exponent_at);
  std::erase(mantissa, '.');
  const int exponent = std::stoi(text.substr(exponent_at + 1)) - (digits - 1);
  return number_of(fmt::format("{}e{}", std::stoll(mantissa) + 1, exponent));
}

}  // namespace

double shortest_decimal(double low, double high) {
  assert(low <= high && std::isfinite(low) && std::isfinite(high));
  if (low <= 0.0 && high >= 0.0) return 0.0;
  if (high < 0.0) return -shortest_decimal(-high, -low);
  for (int digits = 1; digits < 17; ++digits)
    if (const double number = rounded_up(low, digits); number <= high) return number;
  return low;
}

}  // namespace hyrax
