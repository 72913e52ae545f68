#include "tools/app/library/blessing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "tools/files/json.h"
#include "tools/files/json_edit.h"

namespace hyrax {
namespace {

// How many digits a JSON number has behind its point.
int decimals_of(std::string_view number) {
  const std::size_t end = std::min(number.find_first_of("eE"), number.size());
  const std::size_t point = std::min(number.substr(0, end).find('.'), end);
  int exponent = 0;
  if (end < number.size()) exponent = std::atoi(std::string(number.substr(end + 1)).c_str());
  return std::clamp(static_cast<int>(end - std::min(point + 1, end)) - exponent, 0, 300);
}

// A range of the same width around the value, with as many decimals as the old one, whose ends are these
// texts; with more where the value would be outside.
std::vector<std::string> ends_around(double value, const Interval& range,
                                     const std::vector<std::string>& ends) {
  const double width = range.high - range.low;
  int decimals = 0;
  for (const std::string& end : ends) decimals = std::max(decimals, decimals_of(end));
  for (const int decimals_max = decimals + 17; decimals < decimals_max; ++decimals) {
    const auto text = [decimals](double end) {
      std::string digits = fmt::format("{:.{}f}", end, decimals);
      return digits.find_first_not_of("-0.") == digits.npos && digits.front() == '-' ? digits.substr(1)
                                                                                     : digits;
    };
    const std::string low = text(value - width / 2.0), high = text(std::stod(low) + width);
    if (std::stod(low) <= value && value <= std::stod(high)) return {low, high};
  }
  return {to_text(value - width / 2.0), to_text(value + width / 2.0)};
}

std::vector<std::string> counts_around(double count, const Interval& range) {
  const double width = range.high - range.low;
  const double low = std::max(0.0, count - std::floor(width / 2.0));
  return {to_text(Json(static_cast<std::int64_t>(low))),
          to_text(Json(static_cast<std::int64_t>(low + width)))};
}

}  // namespace

std::string with_updated_ranges(std::string text, const std::vector<Expectation>& ranges) {
  for (const Expectation& expectation : ranges) {
    const std::string_view rule = expectation.rule;
    const std::size_t slash = rule.find('/');
    const bool is_count = rule.starts_with("contacts/");
    std::vector<std::string_view> keys = {"expect", rule.substr(0, slash)};
    if (slash != std::string_view::npos) keys.push_back(rule.substr(slash + 1));
    const double value = std::get<double>(expectation.measured);
    const std::vector<std::string> ends = element_texts(text, keys);
    std::vector<std::string> updated =
        is_count ? counts_around(value, *expectation.range) : ends_around(value, *expectation.range, ends);
    updated.resize(ends.size());  // Of a count that is no range.
    text = with_elements(text, keys, updated);
  }
  return text;
}

std::string with_updated_hash(const std::string& text, const std::string& state_hash) {
  return with_elements(text, {"expect", "state_hash"}, {'"' + state_hash + '"'});
}

}  // namespace hyrax
