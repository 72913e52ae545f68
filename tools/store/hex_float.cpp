#include "tools/store/hex_float.h"

#include <charconv>
#include <cmath>

namespace hyrax {

std::string hex_float(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, std::fabs(value), std::chars_format::hex);
  const std::string text(digits, end.ptr);
  return std::string(std::signbit(value) ? "-" : "") + (std::isfinite(value) ? "0x" : "") + text;
}

}  // namespace hyrax
