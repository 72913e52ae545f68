#include "tools/app/comparison/comparison_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/result/number_text.h"
#include "sim/trajectory/columns.h"

namespace hyrax {
namespace {

std::string contact_names(std::uint8_t contact) {
  std::vector<std::string> names;
  for (const Wall wall : kWalls)
    if (touches(contact, wall)) names.emplace_back(name_of(wall));
  if ((contact & kRestBit) != 0) names.emplace_back("rest");
  const int unknown = contact & ~(2 * kRestBit - 1);
  if (unknown != 0) names.push_back(fmt::format("{:#x}", unknown));
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, "+"));
}

// " px" and so on; empty for a field without unit.
std::string unit_of(std::string_view field) {
  const auto column = std::ranges::find(kRowColumns, field, &RowColumn::name);
  return column == kRowColumns.end() ? "" : std::string(" ") + column->unit;
}

// The flags of "contact" by name, other values in decimal and hex float.
std::string value_text(std::string_view field, const std::optional<double>& value) {
  if (!value) return "not stored in the golden file";
  if (is_contact_field(field)) return contact_names(static_cast<std::uint8_t>(*value));
  return fmt::format("{}  ({})", *value, hex_float(*value));
}

std::string divergence_text(const Divergence& first) {
  std::string text = fmt::format("  first      step {}, field {}\n", first.step, first.field);
  if (!first.expected && !first.actual)
    return text + "  the hash of the block of 4,096 rows from this step differs\n";
  text += fmt::format("  expected   {}\n  actual     {}\n", value_text(first.field, first.expected),
                      value_text(first.field, first.actual));
  if (const std::string ulps = ulps_text(first.ulps()); !ulps.empty())
    text += fmt::format("  distance   {}\n", ulps);
  else if (!is_contact_field(first.field) && first.expected && first.actual &&
           std::isfinite(*first.expected - *first.actual))
    text += fmt::format("  distance   {}{}\n", rounded(std::abs(*first.actual - *first.expected), 3),
                        unit_of(first.field));
  return text;
}

std::string row_text(const char* which, const Row& row) {
  return fmt::format("  {:<9}{:>9}  {:>22} {:>22} {:>22} {:>22}  {}\n", which, row.step, row.x_px, row.y_px,
                     row.vx_px_per_s, row.vy_px_per_s, contact_names(row.contact));
}

std::string rows_text(const Comparison& comparison) {
  if (comparison.actual_around.empty()) return "";
  std::string text = fmt::format("  {:<9}{:>9}  {:>22} {:>22} {:>22} {:>22}  contact\n", "rows", "step",
                                 "x px", "y px", "vx px/s", "vy px/s");
  for (std::size_t index = 0; index < comparison.actual_around.size(); ++index) {
    if (index < comparison.expected_around.size())
      text += row_text("expected", comparison.expected_around[index]);
    text += row_text("actual", comparison.actual_around[index]);
  }
  return text;
}

std::string contact_text(const Contact& contact) {
  return fmt::format("{} step {}", name_of(contact.wall), contact.step);
}

template <class List, class Text>
std::string list_text(const char* what, const List& list, std::size_t count_max, const Text& text_of) {
  std::string text;
  for (std::size_t index = 0; index < std::min(list.size(), count_max); ++index)
    text += fmt::format("  {:<11}{}\n", index == 0 ? what : "", text_of(list[index]));
  if (list.size() > count_max) text += fmt::format("  {:<11}and {} more\n", "", list.size() - count_max);
  return text;
}

std::string change_text(double before, double after) {
  if (before == after) return fmt::format("{:.6g}", before);
  const std::string from = fmt::format("{:.6g}", before);
  const std::string to = fmt::format("{:.6g}", after);
  return from == to ? from : from + " -> " + to;
}

std::string settled_text(const RunEnd& end) {
  if (end.settled_since_s) return fmt::format("settled since {:.6g} s", *end.settled_since_s);
  return end.is_rest_known ? "not settled" : "unknown whether settled";
}

std::string end_text(const Comparison& comparison) {
  const Row& a = comparison.expected_end.row;
  const Row& b = comparison.actual_end.row;
  const double px = distance_px(state_of(a), state_of(b));
  const char* const verb = comparison.rest_shift_px() ? "comes to rest" : "ends";
  if (px == 0.0) return fmt::format("{} at the same place", verb);
  return fmt::format("{} {} px away: x {}, y {} px", verb, rounded(px, 3), change_text(a.x_px, b.x_px),
                     change_text(a.y_px, b.y_px));
}

}  // namespace

std::string comparison_line(const char* what, const std::string& text) {
  return fmt::format("  {:<11}{}\n", what, text);
}

std::string ulps_text(const std::optional<std::uint64_t>& ulps) {
  constexpr std::uint64_t kShownMax = 1'000'000;
  return ulps && *ulps <= kShownMax ? plain_counted(*ulps, "ulp") : "";
}

std::string distance_text(const Distance& distance, std::string_view left_out) {
  const auto& [largest, is_at_equal_times, frames_left_out, has_unknown_rows, rows_max] = distance;
  std::string text = has_unknown_rows ? "no position is known to differ" : "no position differs";
  if (largest)
    text = fmt::format("{} px apart at {}{:.4g} s{}", rounded(largest->px, 3),
                       is_at_equal_times ? "" : fmt::format("step {} (", largest->step), largest->t_s,
                       is_at_equal_times ? "" : ")");
  if (is_at_equal_times) text += ", at equal times";
  if (frames_left_out > 0)
    text += fmt::format(" ({} of {} left out)", plain_counted(frames_left_out, "frame"), left_out);
  if (rows_max > 0) text += fmt::format(" in the first {} rows", rows_max);
  if (has_unknown_rows && largest) text += " in the rows that are known";
  return text;
}

std::string contacts_text(const ContactCounts& contacts) {
  if (contacts.total() == 0) return contacts.is_cut ? "no compared contact moved" : "no contact moved";
  std::string text;
  for (const auto& [count, what] :
       {std::pair(contacts.moved, "moved"), {contacts.vanished, "vanished"}, {contacts.appeared, "appeared"}})
    if (count > 0)
      text += fmt::format("{} {}",
                          text.empty() ? plain_counted(count, "contact") : fmt::format(", {}", count), what);
  return (contacts.is_cut ? "at least " : "") + text;
}

std::string comparison_sentence(const Comparison& comparison) {
  return fmt::format("{}, {}{}", distance_text(comparison.distance),
                     contacts_text(comparison.contacts.counts()),
                     comparison.rest_shift_px().value_or(0.0) > 0.0 ? ", " + end_text(comparison) : "");
}

std::string comparison_text(const Comparison& comparison, bool lists_all) {
  const std::size_t count_max = lists_all ? std::numeric_limits<std::size_t>::max() : 8;
  const std::string settled_a = settled_text(comparison.expected_end),
                    settled_b = settled_text(comparison.actual_end);
  std::string text = comparison_line("farthest", distance_text(comparison.distance)) +
                     comparison_line("end", end_text(comparison) + "; " + settled_a +
                                                (settled_a == settled_b ? "" : " -> " + settled_b)) +
                     comparison_line("contacts", contacts_text(comparison.contacts.counts()));
  if (comparison.difference) text += comparison_line("class", std::string(name_of(*comparison.difference)));
  if (!comparison.physics.empty()) text += comparison_line("physics", comparison.physics);
  if (!comparison.shape.empty()) text += comparison_line("shape", comparison.shape);
  if (comparison.first) text += divergence_text(*comparison.first);
  text += rows_text(comparison);
  text += list_text("moved", comparison.contacts.moved, count_max, [](const ContactChanges::Moved& moved) {
    return fmt::format("{} .. {} -> step {} .. {}", contact_text(moved.from), moved.from.last_step,
                       moved.to.step, moved.to.last_step);
  });
  text += list_text("vanished", comparison.contacts.only_a, count_max, contact_text);
  text += list_text("appeared", comparison.contacts.only_b, count_max, contact_text);
  return text;
}

Json::Object comparison_json(const Comparison& comparison) {
  const auto& [largest, is_at_equal_times, frames_left_out, has_unknown_rows, rows_max] = comparison.distance;
  Json first;
  if (comparison.first)
    first = Json::Object{{"step", comparison.first->step},
                         {"field", comparison.first->field},
                         {"expected", or_null(comparison.first->expected)},
                         {"actual", or_null(comparison.first->actual)},
                         {"ulps", or_null(comparison.first->ulps())}};
  return {{"class", comparison.difference ? Json(name_of(*comparison.difference)) : Json()},
          {"max_px", has_unknown_rows && !largest ? Json() : Json(comparison.distance.px())},
          {"contacts_moved", comparison.contacts.total()},
          {"first_divergence", std::move(first)}};
}

std::string worst_text(std::string_view field, const WorstDifference& worst) {
  const std::string ulps = ulps_text(ulps_of(field, worst.a, worst.b));
  const std::string distance = is_contact_field(field)
                                   ? value_text(field, worst.a) + " and " + value_text(field, worst.b)
                                   : fmt::format("{:.6g}{}", worst.abs(), unit_of(field));
  return fmt::format("  worst {:<8}{} at step {}{}\n", field, distance, worst.step,
                     ulps.empty() ? "" : ", " + ulps);
}

}  // namespace hyrax
