#include "sim/search/digits.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace hyrax {
namespace {

// The significant digits of a decimal text: those of its mantissa, without zeros at either end.
std::int64_t significant_digits(std::string_view text) {
  std::int64_t digits = 0;
  std::int64_t zeros = 0;  // Since the last other digit.
  for (const char letter : text.substr(0, text.find('e'))) {
    if (letter < '0' || letter > '9') continue;
    if (letter == '0') {
      zeros += digits > 0 ? 1 : 0;
    } else {
      digits += zeros + 1;
      zeros = 0;
    }
  }
  return digits;
}

template <class Value>
std::int64_t digits_in(const Value& value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return significant_digits({text, static_cast<std::size_t>(end.ptr - text)});
}

void round_value(double& value, int digits) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1);
  std::from_chars(text, end.ptr, value);
}

template <class Whole>
void round_value(Whole& value, int digits) {
  Whole unit = 1;
  for (Whole rest = value; rest != 0; rest /= 10)
    if (--digits < 0) unit *= 10;
  value = value / unit * unit;
}

}  // namespace

std::int64_t digits_of(const Scenario& scenario) {
  Scenario copy = scenario;
  std::int64_t digits = 0;
  for (const NumberField& number : numbers_of(copy))
    digits += std::visit([](const auto* value) { return digits_in(*value); }, number.at);
  return digits;
}

void round_to(const NumberField& number, int digits) {
  std::visit(
      [digits](auto* value) {
        if (digits == 0)
          *value = 0;
        else
          round_value(*value, digits);
      },
      number.at);
}

}  // namespace hyrax
