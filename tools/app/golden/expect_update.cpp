#include "tools/app/golden/expect_update.h"

#include <algorithm>
#include <cmath>

#include "tools/files/json.h"
#include "tools/files/json_edit.h"

namespace hyrax {
namespace {

constexpr std::string_view kContacts = "contacts/";

bool is_count(const Expectation& expectation) { return expectation.rule.starts_with(kContacts); }

std::optional<Interval> interval_of(const Expect& expect, std::string_view rule) {
  if (rule == "final_x_px") return expect.final_x_px;
  if (rule == "final_y_px") return expect.final_y_px;
  if (rule == "at_rest_since_s") return expect.at_rest_since_s;
  const auto is_meant = [&](Wall wall) { return name_of(wall) == rule.substr(kContacts.size()); };
  return expect.contacts[*std::ranges::find_if(kWalls, is_meant)];
}

std::vector<std::string> ends_around(double middle, const Interval& interval, bool is_whole) {
  const double width = interval.high - interval.low;
  if (!is_whole) return {to_text(middle - width / 2.0), to_text(middle + width / 2.0)};
  const double low = std::max(0.0, middle - std::floor(width / 2.0));
  return {to_text(Json(static_cast<std::int64_t>(low))),
          to_text(Json(static_cast<std::int64_t>(low + width)))};
}

}  // namespace

bool is_updatable(const Expectation& broken) {
  if (broken.rule == "state_hash") return true;
  const bool is_range = is_count(broken) || broken.rule == "final_x_px" || broken.rule == "final_y_px" ||
                        broken.rule == "at_rest_since_s";
  return is_range && std::holds_alternative<double>(broken.measured) && !broken.wanted.starts_with("at most");
}

std::string with_updated_ranges(std::string text, const Scenario& scenario,
                                const std::vector<Expectation>& broken) {
  for (const Expectation& expectation : broken) {
    if (!is_updatable(expectation) || expectation.rule == "state_hash") continue;
    const std::string_view rule = expectation.rule;
    std::vector<std::string_view> keys = {"expect"};
    if (is_count(expectation)) keys.push_back(kContacts.substr(0, kContacts.size() - 1));
    keys.push_back(is_count(expectation) ? rule.substr(kContacts.size()) : rule);
    text = with_elements(text, keys,
                         ends_around(std::get<double>(expectation.measured),
                                     *interval_of(*scenario.expect, rule), is_count(expectation)));
  }
  return text;
}

}  // namespace hyrax
