#include "tools/files/table_text.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <concepts>

#include "sim/result/number_text.h"
#include "tools/files/json_pointer.h"

namespace hyrax {
namespace {

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}
std::string csv_field(double value) { return std::isnan(value) ? std::string() : to_text(value); }
std::string csv_field(std::integral auto value) { return std::to_string(value); }
std::string csv_field(const std::optional<std::int64_t>& value) {
  return value ? std::to_string(*value) : std::string();
}
std::string csv_field(bool value) { return value ? "true" : "false"; }
std::string csv_field(const Table&) { return ""; }  // A table within a cell stands by itself.

std::string head_of(const Column& column) {
  if (column.unit.empty() || column.unit == "1") return column.name;
  std::string head = column.name + "_";
  for (const char letter : column.unit) head += letter == '/' ? "_per_" : std::string(1, letter);
  return head;
}

// The text of a cell: field(value) of a column's value in a row.
template <class Field>
auto cell(const Column& column, std::size_t row, const Field& field) {
  assert(column.width == 1);
  return std::visit(
      [&](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        return field(static_cast<const Value&>(values[row]));
      },
      column.values);
}

// How a column of numbers is printed: with as many decimals as its largest value needs to show its digits,
// or, if the values are of very different size, each with these digits.
struct NumberFormat {
  std::chars_format format = std::chars_format::general;
  int precision = 0;
};

NumberFormat format_of(const std::vector<double>& values, int digits) {
  constexpr double kDecadesMax = 3.0;
  double least = HUGE_VAL, most = 0.0;
  bool is_whole = true;
  for (const double value : values) {
    if (!std::isfinite(value) || value == 0.0) continue;
    least = std::min(least, std::fabs(value));
    most = std::max(most, std::fabs(value));
    is_whole = is_whole && value == std::floor(value);
  }
  if (most == 0.0) return {std::chars_format::general, digits};
  if (std::log10(most / least) > kDecadesMax || most >= 1e9 || most < 1e-6)
    return {std::chars_format::general, digits};
  const int before_point = static_cast<int>(std::floor(std::log10(most))) + 1;
  return {std::chars_format::fixed, is_whole ? 0 : std::max(0, digits - before_point)};
}

std::string printed(double value, const NumberFormat& format) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value > 0.0 ? "no bound" : "-no bound";
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, format.format, format.precision).ptr;
  return {text, end};
}

std::string printed_name(const Column& column) {
  std::string name = column.name;
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}
std::string printed_unit(const Column& column) { return column.unit == "1" ? "" : unit_text(column.unit); }

}  // namespace

bool is_text(const Column& column) {
  return std::holds_alternative<std::vector<std::string>>(column.values) ||
         std::holds_alternative<Codes>(column.values);
}

std::string printed_head(const Column& column) {
  const std::string unit = printed_unit(column);
  return printed_name(column) + (unit.empty() ? "" : ", " + unit);
}

std::vector<std::string> printed_values(const Column& column) {
  std::vector<std::string> texts;
  const auto* const numbers = std::get_if<std::vector<double>>(&column.values);
  const NumberFormat format = numbers != nullptr ? format_of(*numbers, column.digits) : NumberFormat{};
  for (std::size_t row = 0; row < length(column); ++row)
    texts.push_back(cell(column, row, [&](const auto& value) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
        return column.is_each_rounded && std::isfinite(value) ? rounded(value, column.digits)
                                                              : printed(value, format);
      else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>)
        return value;
      else
        return csv_field(value);
    }));
  return texts;
}

namespace {

// Letters of UTF-8 text.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xc0) != 0x80; }));
}

// The lines of a column, its head first, all of one width.
std::vector<std::string> aligned(const Column& column, bool has_units_below) {
  std::vector<std::string> lines = printed_values(column);
  if (has_units_below) lines.insert(lines.begin(), printed_unit(column));
  lines.insert(lines.begin(), has_units_below ? printed_name(column) : printed_head(column));
  std::size_t width = 0;
  for (const std::string& line : lines) width = std::max(width, letters(line));
  for (std::string& line : lines)
    line.insert(is_text(column) ? line.size() : 0, std::string(width - letters(line), ' '));
  return lines;
}

// The columns that fit, and how many more there are.
std::string aligned_lines(const Table& table, std::size_t width_max, bool has_units_below) {
  std::vector<std::string> lines(row_count(table) + (has_units_below ? 2 : 1), "  ");
  std::size_t shown = 0;
  for (; shown < table.columns.size(); ++shown) {
    const std::vector<std::string> added = aligned(table.columns[shown], has_units_below);
    if (shown > 0 && letters(lines.front() + added.front()) + 2 > width_max) break;
    for (std::size_t line = 0; line < lines.size(); ++line)
      lines[line] += (shown == 0 ? "" : "  ") + added[line];
  }
  std::string text;
  for (const std::string& line : lines) text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  if (const std::size_t more = table.columns.size() - shown; more > 0)
    text += "  " + plain_counted(more, "more column") + " with --verbose\n";
  return text;
}

Json json_cell(const Column& column, std::size_t row) {
  return cell(column, row, [](const auto& value) -> Json {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, Table>) {
      return json_of(value);
    } else {
      if constexpr (std::is_same_v<Value, double>)
        if (std::isnan(value)) return nullptr;
      if constexpr (std::is_same_v<Value, std::optional<std::int64_t>>)
        return or_null(value);
      else
        return Json(value);
    }
  });
}

Json key_values(const Table& table, std::size_t row, std::size_t first_column) {
  Json object = Json::Object();
  for (std::size_t index = first_column; index < table.columns.size(); ++index) {
    const Column& column = table.columns[index];
    if (const std::string key = key_of(column); key != "-") set_at(object, "/" + key, json_cell(column, row));
  }
  return object;
}

}  // namespace

std::string key_of(const Column& column) {
  if (!column.key.empty()) return column.key;
  std::string key = head_of(column);
  for (char& letter : key)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return key;
}

std::string aligned_text(const Table& table, std::size_t width_max) {
  std::size_t heads_width = 0;  // The values, which may be measured, do not decide.
  for (const Column& column : table.columns)
    heads_width += letters(column.name) + (column.unit.empty() ? 2 : letters(column.unit) + 4);
  return aligned_lines(table, width_max, heads_width > std::min<std::size_t>(100, width_max));
}

std::string csv_text(const Table& table) {
  std::string text;
  const auto add_line = [&](const auto& field_of) {
    bool is_first = true;
    for (const Column& column : table.columns) {
      if (!is_first) text += ",";
      is_first = false;
      text += field_of(column);
    }
    text += "\n";
  };
  add_line([](const Column& column) { return csv_field(head_of(column)); });
  for (std::size_t row = 0; row < row_count(table); ++row)
    add_line([row](const Column& column) {
      return cell(column, row, [](const auto& value) { return csv_field(value); });
    });
  return text;
}

Json json_of(const Table& table) {
  assert(table.form != JsonForm::members);
  if (table.form == JsonForm::one) return row_count(table) == 0 ? Json() : key_values(table, 0, 0);
  if (table.form == JsonForm::by_first) {
    Json::Object object;
    const std::vector<std::string> keys =
        table.columns.empty() ? std::vector<std::string>() : printed_values(table.columns.front());
    for (std::size_t row = 0; row < keys.size(); ++row)
      object.push_back({keys[row], key_values(table, row, 1)});
    return object;
  }
  Json::Array array;
  for (std::size_t row = 0; row < row_count(table); ++row)
    array.push_back(table.form == JsonForm::values ? json_cell(table.columns.front(), row)
                                                   : key_values(table, row, 0));
  return array;
}

void add_members(Json::Object& object, const std::vector<Table>& tables) {
  for (const Table& table : tables) {
    if (table.form != JsonForm::members)
      object.push_back({table.name, json_of(table)});
    else
      for (const Column& column : table.columns) object.push_back({key_of(column), json_cell(column, 0)});
  }
}

}  // namespace hyrax
