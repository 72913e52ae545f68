#include "tools/app/drift/start_dependence.h"

#include <fmt/format.h>

#include <charconv>

#include "tools/files/table_text.h"

namespace hyrax {
namespace {

// Two digits, never more than the value.
std::string rounded_down(double value) {
  std::string text = fmt::format("{:.17e}", value);
  text.erase(text.find('.') + 2, 16);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return fmt::format("{:g}", rounded);
}

std::string chance_text(const ContactChance& chance) {
  const std::string within = fmt::format("within ±{:g} px of the start, ", chance.within_px);
  if (chance.changed.of == 0) return within + "no contact changes";
  return within +
         fmt::format("contacts change for {:.2g} % of starts ({:.2g} .. {:.2g} %; {} starts, seed {})",
                     100.0 * chance.chance(), 100.0 * chance.low(), 100.0 * chance.high(), chance.changed.of,
                     chance.seed);
}

// Of the end to the start, as long as no contact changes.
std::string sensitivity_text(const Sensitivity& sensitivity) {
  const std::vector<std::string> names = {"x", "y", "vx", "vy"};
  Table table{.columns = {{.name = "end moves by", .values = names}}};
  for (std::size_t column = 0; column < names.size(); ++column)
    table.columns.push_back(column_of(
        "of start " + names[column], "", "", sensitivity, [column](const auto& row) { return row[column]; },
        3));
  const std::string text = aligned_text(table);
  return text.substr(0, text.size() - 1);
}

Table decision_table(const std::optional<NearestDecision>& nearest) {
  Table table{.columns = {}, .shape = JsonShape::one};
  if (nearest)
    table.columns = {
        column_of_one("decision", "", kDecisionNames[static_cast<std::size_t>(nearest->decision)]),
        column_of_one("step", "", nearest->step), column_of_one("taken", "", nearest->is_taken)};
  return table;
}

Table chance_table(const ContactChance& chance) {
  return {.columns = {column_of_one("within", "px", chance.within_px),
                      column_of_one("chance", "1", chance.chance()), column_of_one("low", "1", chance.low()),
                      column_of_one("high", "1", chance.high()),
                      column_of_one("drawn_part", "1", chance.drawn_part),
                      column_of_one("starts", "1", chance.changed.of),
                      column_of_one("changed", "1", chance.changed.count),
                      column_of_one("steps", "1", chance.steps), column_of_one("seed", "", chance.seed)},
          .shape = JsonShape::one};
}

}  // namespace

bool is_knife_edge(const Margin& margin) {
  constexpr double kKnifeEdge = 1e-9;
  return margin.half_width && *margin.half_width < kKnifeEdge;
}

std::string margin_text(const Margin& margin) {
  if (!margin.half_width || !margin.nearest) return "no start changes the contacts";
  return fmt::format("any start within ±{} px and px/s keeps all contacts; nearest decision: {}, step {}",
                     rounded_down(*margin.half_width),
                     kDecisionNames[static_cast<std::size_t>(margin.nearest->decision)],
                     margin.nearest->step);
}

std::string start_text(const StartDependence& start, bool all) {
  std::string text = "  " + margin_text(start.margin);
  if (start.contact_chance) text += "\n  " + chance_text(*start.contact_chance);
  if (all) text += "\n" + sensitivity_text(start.margin.sensitivity);
  return text;
}

Table sensitivity_table(const Sensitivity& sensitivity) {
  std::vector<Table> rows;
  for (const auto& row : sensitivity)
    rows.push_back(
        {.columns = {{.values = std::vector(row.begin(), row.end())}}, .shape = JsonShape::values});
  return {.name = "sensitivity", .columns = {{.values = rows}}, .shape = JsonShape::values};
}

Table margin_table(const StartDependence& start) {
  const Margin& margin = start.margin;
  Table table{.name = "margin",
              .columns = {column_of_one("half_width", "", margin.half_width),
                          column_of_one("nearest_decision", "", decision_table(margin.nearest)),
                          column_of_one("sensitivity", "", sensitivity_table(margin.sensitivity)),
                          column_of_one("sensitivity_norm", "", margin.sensitivity_norm)},
              .shape = JsonShape::one};
  if (start.contact_chance)
    table.columns.push_back(column_of_one("contact_change", "", chance_table(*start.contact_chance)));
  return table;
}

}  // namespace hyrax
