#include "tools/app/drift/drift.h"

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
  Table table{.columns = {}, .form = JsonForm::one};
  if (nearest)
    table.columns = {
        column_of_one("decision", "", kDecisionNames[static_cast<std::size_t>(nearest->decision)]),
        column_of_one("step", "", nearest->step), column_of_one("taken", "", nearest->is_taken)};
  return table;
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

std::string start_text(const Margin& margin, bool all) {
  return "  " + margin_text(margin) + (all ? "\n" + sensitivity_text(margin.sensitivity) : "");
}

Table sensitivity_table(const Sensitivity& sensitivity) {
  std::vector<Table> rows;
  for (const auto& row : sensitivity)
    rows.push_back({.columns = {{.values = std::vector(row.begin(), row.end())}}, .form = JsonForm::values});
  return {.name = "sensitivity", .columns = {{.values = rows}}, .form = JsonForm::values};
}

Table margin_table(const Margin& margin) {
  return {.name = "margin",
          .columns = {column_of_one("half_width", "", margin.half_width),
                      column_of_one("nearest_decision", "", decision_table(margin.nearest)),
                      column_of_one("sensitivity", "", sensitivity_table(margin.sensitivity)),
                      column_of_one("sensitivity_norm", "", margin.sensitivity_norm)},
          .form = JsonForm::one};
}

}  // namespace hyrax
