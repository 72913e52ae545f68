// Numbers for people: in pictures and in printed text, and on the pages (numbers.js) by the same rules.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace hyrax {

/// The next double farther from 0: of two equally near texts its own is the farther one, as in JavaScript.
[[nodiscard]] inline double farther_from_0(double value) {
  return std::nextafter(value, std::copysign(std::numeric_limits<double>::max(), value));
}

/// A number with so many decimals at least 0, its thousands apart: "11,400", "-0.50".
[[nodiscard]] inline std::string with_decimals(double value, int decimals) {
  char letters[400];
  std::snprintf(letters, sizeof letters, "%.*f", decimals,
                value == 0.0 ? 0.0 : farther_from_0(std::fabs(value)));
  std::string text = letters;
  const std::size_t point = std::min(text.find('.'), text.size());
  for (std::size_t at = point; at > 3; at -= 3) text.insert(at - 3, 1, ',');
  const bool is_zero = text.find_first_not_of("0.,") == text.npos;
  return value < 0.0 && !is_zero ? "-" + text : text;
}

/// `digits` significant digits at least of what is before the point, without needless zeros: "1,234.5",
/// "0.0312"; below 0.001 and from ten million on with a power of ten, "3.2e-12". A NaN is "–".
[[nodiscard]] inline std::string rounded(double value, int digits = 4) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value < 0.0 ? "-Infinity" : "Infinity";
  if (value == 0.0) return "0";
  const double size = std::fabs(value);
  if (size >= 1e7 || size < 1e-3) {
    char letters[40];
    std::snprintf(letters, sizeof letters, "%.*e", std::min(digits, 2) - 1,
                  size < 1.0 ? value : farther_from_0(value));
    const std::string text = letters;
    const std::size_t e = text.find('e');
    return text.substr(0, text.substr(0, e).ends_with(".0") ? e - 2 : e) + "e" +
           std::to_string(std::stoi(text.substr(e + 1)));
  }
  const int decimals = std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(size))), 0, 8);
  std::string text = with_decimals(value, decimals);
  if (text.find('.') != text.npos) text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// A unit as people write it, "px²/s²" of the "px2/s2" that files have.
[[nodiscard]] inline std::string unit_text(std::string unit) {
  for (std::size_t at = unit.find('2'); at != unit.npos; at = unit.find('2', at)) unit.replace(at, 1, "²");
  return unit;
}

/// "1 step", "11,400 steps".
template <class Count>
[[nodiscard]] std::string counted(Count count, const std::string& noun) {
  return with_decimals(static_cast<double>(count), 0) + " " + noun + (count == 1 ? "" : "s");
}
/// "1 step", "11400 steps".
template <class Count>
[[nodiscard]] std::string plain_counted(Count count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace hyrax
