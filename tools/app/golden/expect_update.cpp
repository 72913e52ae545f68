#include "tools/app/golden/expect_update.h"

#include <algorithm>
#include <cmath>

#include "tools/files/json.h"
#include "tools/files/json_edit.h"

namespace hyrax {
namespace {

constexpr std::string_view kContacts = "contacts/";

std::vector<std::string> ends_around(double middle, const Interval& interval, bool is_whole) {
  const double width = interval.high - interval.low;
  if (!is_whole) return {to_text(middle - width / 2.0), to_text(middle + width / 2.0)};
  const double low = std::max(0.0, middle - std::floor(width / 2.0));
  return {to_text(Json(static_cast<std::int64_t>(low))),
          to_text(Json(static_cast<std::int64_t>(low + width)))};
}

}  // namespace

bool is_updatable_range(const Expectation& broken) {
  return broken.range && std::isfinite(broken.range->low) && std::holds_alternative<double>(broken.measured);
}

bool is_updatable(const Expectation& broken) {
  return broken.rule == "state_hash" || is_updatable_range(broken);
}

std::string with_updated_ranges(std::string text, const std::vector<Expectation>& ranges) {
  for (const Expectation& expectation : ranges) {
    const std::string_view rule = expectation.rule;
    const bool is_count = rule.starts_with(kContacts);
    std::vector<std::string_view> keys = {"expect"};
    if (is_count) keys.push_back(kContacts.substr(0, kContacts.size() - 1));
    keys.push_back(is_count ? rule.substr(kContacts.size()) : rule);
    text = with_elements(text, keys,
                         ends_around(std::get<double>(expectation.measured), *expectation.range, is_count));
  }
  return text;
}

}  // namespace hyrax
