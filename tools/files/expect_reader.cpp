#include "tools/files/expect_reader.h"

#include <algorithm>
#include <cmath>

#include "tools/files/quantity_reader.h"

namespace hyrax {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// [low, high], where a number does not have a meaning of its own.
std::optional<Interval> read_interval(const JsonPlace& here, const std::string& or_a_number = "") {
  if (!here.is_there()) return std::nullopt;
  const auto* array = here.json()->get<Json::Array>();
  if (array == nullptr || array->size() != 2 || !(*array)[0].is_number() || !(*array)[1].is_number() ||
      (*array)[0].number() > (*array)[1].number()) {
    here.breaks_rule("must be [low, high] with low <= high" + or_a_number);
    return std::nullopt;
  }
  return Interval{(*array)[0].number(), (*array)[1].number()};
}

std::optional<Interval> read_time(const JsonPlace& here) {
  if (here.is_there() && here.json()->is_number()) return Interval{-kInfinity, here.json()->number()};
  return read_interval(here, ", or a number, the upper bound");
}

std::optional<Interval> read_count(const JsonPlace& here) {
  const bool is_exact = here.is_there() && here.json()->is_number();
  const auto interval = is_exact ? std::optional(Interval{here.json()->number(), here.json()->number()})
                                 : read_interval(here, ", or a number, meant exactly");
  const auto is_count = [](double value) {
    return value >= 0.0 && value <= 1e15 && std::floor(value) == value;
  };
  if (interval && (!is_count(interval->low) || !is_count(interval->high)))
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
  expect.final_x_px = read_interval(here.member("final_x_px"));
  expect.final_y_px = read_interval(here.member("final_y_px"));
  expect.at_rest_since_s = read_time(here.member("at_rest_since_s"));
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
