#include "sim/described/value.h"

#include <charconv>

namespace hyrax {

double shown_number_of(ValueType type, Word word) {
  double number = number_of(type, word);
  if (type != ValueType::float32) return number;
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value_of<float>(word));
  std::from_chars(text, written.ptr, number);
  return number;
}

std::string unit_of(std::string_view name) {
  while (true) {  // The last part that is no number.
    const std::size_t dot = name.rfind('.');
    const std::string_view part = name.substr(dot == std::string_view::npos ? 0 : dot + 1);
    if (dot == std::string_view::npos || part.find_first_not_of("0123456789") != std::string_view::npos) {
      name = part;
      break;
    }
    name = name.substr(0, dot);
  }
  struct Unit {
    std::string_view ending;
    std::string_view text;
    bool has_rates;
  };
  constexpr std::array<Unit, 6> kUnits = {{{"_px", "px", true},
                                           {"_m", "m", true},
                                           {"_rad", "rad", true},
                                           {"_deg", "deg", true},
                                           {"_s", "s", false},
                                           {"_hz", "Hz", false}}};
  // A rate of another word has no unit, though it ends in "_s".
  const bool is_per_s2 = name.ends_with("_per_s2");
  const bool is_per_s = name.ends_with("_per_s");
  if (is_per_s2) name.remove_suffix(7);
  if (is_per_s) name.remove_suffix(6);
  const std::string_view rate = is_per_s2 ? "/s^2" : is_per_s ? "/s" : "";
  for (const Unit& unit : kUnits)
    if (name.ends_with(unit.ending) && (rate.empty() || unit.has_rates))
      return std::string(unit.text).append(rate);
  return {};
}

}  // namespace hyrax
