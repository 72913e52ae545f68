#include "tools/app/diff/difference_text.h"

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

// "3 ulps"; empty without any, or beyond a million: they say how far rounding went, and nothing of more.
std::string ulps_text(const std::optional<std::uint64_t>& ulps) {
  constexpr std::uint64_t kShownMax = 1'000'000;
  return ulps && *ulps <= kShownMax ? plain_counted(*ulps, "ulp") : "";
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

std::string_view meaning(DifferenceClass difference, bool builds_differ) {
  if (difference == DifferenceClass::shape)
    return "not explained by the build: the files are not two intact runs of one scenario with the same "
           "inputs";
  if (!builds_differ) return "not explained by the build: usually the core changed between the runs";
  return "strict builds give the same bits with all build settings: usually one of the two fuses\n"
         "             multiply-adds, or the core changed as well; `hyrax-sim check` with each of the\n"
         "             programs shows which one differs from the golden files";
}

std::string change_text(double before, double after) {
  if (before == after) return fmt::format("{:.6g}", before);
  const std::string from = fmt::format("{:.6g}", before);
  const std::string to = fmt::format("{:.6g}", after);
  return from == to ? from : from + " -> " + to;
}

std::string settled_text(const TrajectoryDiff& diff) {
  const auto text = [](const RunEnd& end) {
    if (end.settled_since_s) return fmt::format("settled since {:.6g} s", *end.settled_since_s);
    return std::string(end.has_every_row ? "not settled" : "unknown whether settled");
  };
  const std::string a = text(diff.end_a);
  const std::string b = text(diff.end_b);
  return a == b ? a : a + " -> " + b;
}

std::string end_text(const TrajectoryDiff& diff) {
  const Row& a = diff.end_a.row;
  const Row& b = diff.end_b.row;
  const double shift_px = distance_px(state_of(a), state_of(b));
  const std::string apart = shift_px == 0.0 ? "the same place" : rounded(shift_px, 3) + " px apart";
  return fmt::format("  {:<11}{}: x {}, y {} px; {}\n", diff.comparison.rest_shift_px ? "rest" : "end", apart,
                     change_text(a.x_px, b.x_px), change_text(a.y_px, b.y_px), settled_text(diff));
}

std::string energy_text(const EnergyDifference& energy) {
  if (!energy.largest()) return "  energy     no difference\n";
  const double change = energy.largest()->px2_per_s2;
  return fmt::format("  energy     at most {}{} px²/s², at step {}\n", change > 0.0 ? "+" : "",
                     rounded(change, 3), energy.largest()->step);
}

std::string worst_text(std::string_view field, const WorstDifference& worst) {
  const std::string ulps = ulps_text(ulps_of(field, worst.a, worst.b));
  const std::string distance = is_contact_field(field)
                                   ? value_text(field, worst.a) + " and " + value_text(field, worst.b)
                                   : fmt::format("{:.6g}{}", worst.abs(), unit_of(field));
  return fmt::format("  worst {:<8}{} at step {}{}\n", field, distance, worst.step,
                     ulps.empty() ? "" : ", " + ulps);
}

}  // namespace

std::string difference_text(const Comparison& comparison, bool lists_all) {
  const std::size_t count_max = lists_all ? std::numeric_limits<std::size_t>::max() : 8;
  std::string text;
  if (comparison.difference) text += fmt::format("  class      {}\n", name_of(*comparison.difference));
  if (!comparison.physics.empty()) text += fmt::format("  physics    {}\n", comparison.physics);
  if (!comparison.shape.empty()) text += fmt::format("  shape      {}\n", comparison.shape);
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

std::string build_text(const Provenance& a, const Provenance& b,
                       const std::optional<DifferenceClass>& difference) {
  bool builds_differ = false, is_recorded = true;
  std::string changes;
  for (std::size_t index = 0; index < a.size(); ++index) {
    is_recorded = is_recorded && a[index] && b[index];
    if (!a[index] || !b[index] || a[index] == b[index]) continue;
    // The program's version is no setting of its build.
    builds_differ = builds_differ || kProvenanceNames[index] != std::string_view("program");
    changes += fmt::format("             {}: '{}' and '{}'\n", kProvenanceNames[index], *a[index], *b[index]);
  }
  const std::string text = fmt::format("  build settings: {}{}\n{}", builds_differ ? "differ" : "identical",
                                       is_recorded ? "" : " where recorded", changes);
  return difference ? text + fmt::format("  meaning    {}\n", meaning(*difference, builds_differ)) : text;
}

Json max_px_json(const Comparison& comparison) { return comparison.largest ? comparison.largest->px : 0.0; }

Json divergence_json(const std::optional<Divergence>& divergence) {
  if (!divergence) return nullptr;
  return Json::Object{{"step", divergence->step},
                      {"field", divergence->field},
                      {"expected", or_null(divergence->expected)},
                      {"actual", or_null(divergence->actual)},
                      {"ulps", or_null(divergence->ulps())}};
}

std::string distance_sentence(const TrajectoryDiff& diff) {
  const auto& largest = diff.comparison.largest;
  return largest ? "at most " + rounded(largest->px, 3) + " px apart" : "no position differs";
}

std::string contacts_sentence(const ContactChanges& contacts) {
  if (contacts.is_none()) return contacts.is_cut ? "no recorded contact moved" : "no contact moved";
  return fmt::format("{}{} moved, {} vanished, {} appeared", contacts.is_cut ? "at least " : "",
                     plain_counted(contacts.moved.size(), "contact"), contacts.only_a.size(),
                     contacts.only_b.size());
}

std::string consequence_text(const TrajectoryDiff& diff) {
  const auto& largest = diff.comparison.largest;
  std::string text = fmt::format(
      "  apart      {}", largest ? "at most " + rounded(largest->px, 3) + " px" : distance_sentence(diff));
  if (largest) text += fmt::format(", at step {} ({:.4g} s)", largest->step, diff.largest_at_s.value_or(0.0));
  text += diff.is_by_time ? "; rows of the same time\n" : "\n";
  return text + end_text(diff) +
         fmt::format("  contacts   {}\n", contacts_sentence(diff.comparison.contacts)) +
         (diff.energy ? energy_text(*diff.energy) : "");
}

std::string values_text(const TrajectoryDiff& diff, bool lists_all) {
  const Comparison& comparison = diff.comparison;
  std::string text = difference_text(comparison, lists_all);
  const std::int64_t total_a = diff.end_a.contacts_total, total_b = diff.end_b.contacts_total;
  if (comparison.contacts.is_none() && total_a != total_b)
    text += fmt::format("  total      the numbers of contacts differ: {} and {}\n", total_a, total_b);
  else if (comparison.difference && comparison.shape.empty() && comparison.contacts.is_none() &&
           !comparison.first)
    text += "  hash       the state hashes differ: in rows that are not recorded in both\n";
  for (std::size_t field = 0; field < kRowFields.size(); ++field)
    if (const auto& worst = diff.values.worst()[field]) text += worst_text(kRowFields[field].name, *worst);
  return text;
}

Json diff_json(const TrajectoryDiff& diff) {
  const Comparison& comparison = diff.comparison;
  Json::Object worst;
  for (std::size_t field = 0; field < kRowFields.size(); ++field)
    if (const auto& value = diff.values.worst()[field]) {
      const auto ulps = ulps_of(kRowFields[field].name, value->a, value->b);
      worst.emplace_back(kRowFields[field].name,
                         Json::Object{{"step", value->step}, {"abs", value->abs()}, {"ulps", or_null(ulps)}});
    }
  const auto count = [](const auto& list) { return Json(static_cast<std::int64_t>(list.size())); };
  return Json::Object{{"agree", comparison.agrees},
                      {"class", comparison.difference ? Json(name_of(*comparison.difference)) : Json()},
                      {"first_divergence", divergence_json(comparison.first)},
                      {"worst", std::move(worst)},
                      {"contacts", Json::Object{{"moved", count(comparison.contacts.moved)},
                                                {"only_a", count(comparison.contacts.only_a)},
                                                {"only_b", count(comparison.contacts.only_b)}}}};
}

}  // namespace hyrax
