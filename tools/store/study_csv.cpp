#include "tools/store/study_csv.h"

#include <cmath>

#include "tools/files/json.h"

namespace hyrax {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}
std::string field(double value) { return std::isnan(value) ? std::string() : to_text(value); }
std::string field(std::int64_t value) { return std::to_string(value); }

std::string head_of(const StudyColumn& column) {
  if (column.unit.empty() || column.unit == "1") return field(column.name);
  std::string head = column.name + "_";
  for (const char letter : column.unit) head += letter == '/' ? "_per_" : std::string(1, letter);
  return field(head);
}

}  // namespace

std::string csv_text(const StudyTable& table) {
  std::string text;
  const auto add_line = [&](const auto& cell) {
    bool is_first = true;
    for (const StudyColumn& column : table.columns) {
      if (!is_first) text += ",";
      is_first = false;
      text += cell(column);
    }
    text += "\n";
  };
  add_line(head_of);
  for (std::size_t row = 0; row < row_count(table); ++row)
    add_line([row](const StudyColumn& column) {
      return std::visit([row](const auto& values) { return field(values[row]); }, column.values);
    });
  return text;
}

}  // namespace hyrax
