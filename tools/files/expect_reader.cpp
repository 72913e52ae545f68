#include "tools/files/expect_reader.h"

#include <algorithm>

#include "tools/files/quantity_reader.h"

namespace hyrax {
namespace {

std::optional<Interval> read_interval(const JsonPlace& here, const std::string& number_means,
                                      double low_of_number, bool number_is_exact) {
  if (!here.is_there()) return std::nullopt;
  if (here.json()->is_number()) {
    const double value = here.json()->number();
    return Interval{number_is_exact ? value : low_of_number, value};
  }
  const auto* array = here.json()->get<Json::Array>();
  if (array == nullptr || array->size() != 2 || !(*array)[0].is_number() || !(*array)[1].is_number() ||
      (*array)[0].number() > (*array)[1].number()) {
    here.breaks_rule("must be [low, high] with low <= high, or a number, " + number_means);
    return std::nullopt;
  }
  return Interval{(*array)[0].number(), (*array)[1].number()};
}

std::optional<Interval> read_bounds(const JsonPlace& here) {
  return read_interval(here, "the upper bound", -std::numeric_limits<double>::infinity(), false);
}

std::optional<Interval> read_count(const JsonPlace& here) {
  const auto interval = read_interval(here, "meant exactly", 0.0, true);
  const auto is_count = [](double value) {
    return value >= 0.0 && value == static_cast<double>(static_cast<std::int64_t>(value));
  };
  if (interval && (interval->high > 1e15 || !is_count(interval->low) || !is_count(interval->high)))
    here.breaks_rule("must count in whole numbers of 0 or more");
  return interval;
}

std::optional<std::string> read_hash(const JsonPlace& here) {
  const auto text = here.text();
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (text && (text->size() != 32 || !std::all_of(text->begin(), text->end(), is_digit)))
    here.breaks_rule("must be 32 hex digits, 0-9 and a-f");
  return text;
}

}  // namespace

Expect read_expect(const JsonPlace& here) {
  Expect expect;
  if (!here.is_object_of({"in_bounds", "finite", "final_x_px", "final_y_px", "at_rest_since_s", "contacts",
                          "state_hash", "implementation_px_max", "truncation_px_max",
                          "energy_drift_rel_max"}))
    return expect;
  expect.in_bounds = here.member("in_bounds").boolean();
  expect.finite = here.member("finite").boolean();
  expect.final_x_px = read_bounds(here.member("final_x_px"));
  expect.final_y_px = read_bounds(here.member("final_y_px"));
  expect.at_rest_since_s = read_bounds(here.member("at_rest_since_s"));
  if (const JsonPlace contacts = here.member("contacts");
      contacts.is_there() && contacts.is_object_of({"left", "right", "top", "ground"}))
    expect.contacts = {read_count(contacts.member("left")), read_count(contacts.member("right")),
                       read_count(contacts.member("top")), read_count(contacts.member("ground"))};
  expect.state_hash = read_hash(here.member("state_hash"));
  expect.implementation_px_max = here.member("implementation_px_max").number(kNotNegativeRule);
  expect.truncation_px_max = here.member("truncation_px_max").number(kNotNegativeRule);
  expect.energy_drift_rel_max = here.member("energy_drift_rel_max").number(kNotNegativeRule);
  return expect;
}

}  // namespace hyrax
