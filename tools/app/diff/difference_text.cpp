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

std::string value_text(std::string_view field, const std::optional<double>& value) {
  return value ? field_value_text(field, *value) : std::string("not stored in the golden file");
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

}  // namespace

std::string unit_of(std::string_view field) {
  const auto column = std::ranges::find(kRowColumns, field, &RowColumn::name);
  return column == kRowColumns.end() ? "" : std::string(" ") + column->unit;
}

std::string ulps_text(const std::optional<std::uint64_t>& ulps) {
  constexpr std::uint64_t kShownMax = 1'000'000;
  return ulps && *ulps <= kShownMax ? plain_counted(*ulps, "ulp") : "";
}

std::string field_value_text(std::string_view field, double value) {
  if (is_contact_field(field)) return contact_names(static_cast<std::uint8_t>(value));
  return fmt::format("{}  ({})", value, hex_float(value));
}

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

}  // namespace hyrax
