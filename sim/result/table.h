// A table of plain columns with units: the one form in which a study hands on numbers. Text, CSV, JSON and
// HDF5 are made of it by code that knows no study.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hyrax {

struct Table;

/// One quantity, one value a row.
struct Column {                // NOLINT(misc-no-recursion): copied with the tables in its cells.
  std::string name = {};       ///< snake_case, without its unit.
  std::string unit = {};       ///< "px", "px/s", "1" for a pure number; empty for text.
  std::string long_name = {};  ///< What it is, in a few words.
  /// A number that is missing is a NaN. A table in a cell is for JSON only.
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>, std::vector<bool>,
               std::vector<Table>>
      values;      // Without "= {}", for which clang 14 needs Table complete.
  int digits = 4;  ///< Significant digits in printed text; files have all.
};

/// What a table is in JSON.
enum class JsonShape : std::uint8_t {
  rows,      ///< An array of objects, one a row.
  values,    ///< An array of the first column's values.
  by_first,  ///< An object: keyed by the first column's values, of objects of the other columns.
  one,       ///< The first row as an object; null without rows.
  members    ///< The first row's values, as members of the object around the table.
};

struct Table {            // NOLINT(misc-no-recursion)
  std::string name = {};  ///< snake_case, unique within a study.
  std::string long_name = {};
  std::vector<Column> columns = {};  ///< All of one length.
  JsonShape shape = JsonShape::rows;
};

/// Rows of the column.
[[nodiscard]] inline std::size_t length(const Column& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
}

/// Rows of the table; 0 without columns. REQUIRES: all columns have one length.
[[nodiscard]] inline std::size_t row_count(const Table& table) {
  for ([[maybe_unused]] const Column& column : table.columns)
    assert(length(column) == length(table.columns.front()));
  return table.columns.empty() ? 0 : length(table.columns.front());
}

/// A column with a value of each record: `get` is a function of the record, or a pointer to its member.
/// Value is double, std::int64_t, bool, std::string or Table.
template <class Value, class Records, class Get>
[[nodiscard]] Column column_of(const std::string& name, const std::string& unit, const std::string& long_name,
                               const Records& records, const Get& get, int digits = 4) {
  std::vector<Value> values;
  values.reserve(std::size(records));
  for (const auto& record : records) values.push_back(Value(std::invoke(get, record)));
  return {name, unit, long_name, std::move(values), digits};
}

}  // namespace hyrax
