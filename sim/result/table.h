// A table of plain columns with units: the one form in which numbers are handed on. Text, CSV, JSON and HDF5
// are made of it by code that does not know what they are.
#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "sim/result/value_type.h"

namespace hyrax {

struct Table;

/// The names of codes 0, 1, 2, ..., or of 1, 2, 4, ...
struct CodeNames {
  std::span<const std::string_view> names = {};
  bool are_bits = false;

  [[nodiscard]] std::string_view of(std::uint8_t code) const {
    return names[are_bits ? static_cast<std::size_t>(std::countr_zero(code)) : code];
  }
};

/// Codes with names: text and JSON have the name, HDF5 the code and the list. Without names: bytes, for HDF5
/// only.
struct Codes {
  using value_type = std::string_view;
  CodeNames names = {};
  std::vector<std::uint8_t> codes = {};

  [[nodiscard]] std::size_t size() const { return codes.size(); }
  [[nodiscard]] std::string_view operator[](std::size_t row) const { return names.of(codes[row]); }
};

/// One quantity, `width` values a row.
struct Column {                // NOLINT(misc-no-recursion): copied with the tables in its cells.
  std::string name = {};       ///< snake_case, without its unit.
  std::string unit = {};       ///< "px", "px/s", "1" for a pure number; empty for text.
  std::string long_name = {};  ///< What it is, in a few words.
  /// A number that is missing is a NaN, an integer -1 in HDF5. A table in a cell is for JSON only.
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint64_t>,
               std::vector<std::string>, std::vector<bool>, std::vector<std::optional<std::int64_t>>, Codes,
               std::vector<Table>>
      values;      // Without "= {}", for which clang 14 needs Table complete.
  int digits = 4;  ///< Significant digits in printed text; files have all.
  /// Each value is printed with these digits; else all with as many decimals as the largest needs for them.
  bool is_each_rounded = false;
  /// In JSON, where it is not NAME_UNIT; "OBJECT/KEY" is a member of an object, "-" is none.
  std::string key = {};
  /// Values in each row; `values` has row after row. Text, CSV and JSON have 1 only.
  std::size_t width = 1;
  /// The type of numbers in HDF5, where it is narrower than that of `values`. With names of 0, 1, ... it is
  /// an enum.
  std::optional<ValueType> stored_as = {};
  std::vector<std::string> value_names = {};
};

/// What a table is in JSON.
enum class JsonForm : std::uint8_t {
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
  JsonForm form = JsonForm::rows;
};

/// Rows of the column.
[[nodiscard]] inline std::size_t length(const Column& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values) / column.width;
}

/// Calls a function with the column's vector of numbers, or of codes. REQUIRES: the column has numbers or
/// codes.
void with_numbers(auto& column, const auto& take) {
  std::visit(
      [&](auto& values) {
        using Values = std::decay_t<decltype(values)>;
        if constexpr (std::is_same_v<Values, Codes>)
          take(values.codes);
        else if constexpr (std::is_arithmetic_v<typename Values::value_type> &&
                           !std::is_same_v<Values, std::vector<bool>>)
          take(values);
        else
          assert(false);
      },
      column.values);
}

/// Rows of the table; 0 without columns. REQUIRES: all columns have one length.
[[nodiscard]] inline std::size_t row_count(const Table& table) {
  for ([[maybe_unused]] const Column& column : table.columns)
    assert(length(column) == length(table.columns.front()));
  return table.columns.empty() ? 0 : length(table.columns.front());
}

/// A value as columns have it: of an integer a std::int64_t, of a missing number a NaN.
template <class Value>
[[nodiscard]] auto column_value(const Value& value) {
  if constexpr (std::is_same_v<Value, std::optional<double>>)
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
  else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>)
    return static_cast<std::int64_t>(value);
  else if constexpr (std::is_convertible_v<Value, std::string_view>)
    return std::string(value);
  else
    return value;
}

/// A column with a value of each record: `get` is a function of the record, or a pointer to its member.
/// It gives a number, a bool, a text or a Table.
template <class Records, class Get>
[[nodiscard]] Column column_of(const std::string& name, const std::string& unit, const std::string& long_name,
                               const Records& records, const Get& get, int digits = 4) {
  std::vector<decltype(column_value(std::invoke(get, *std::begin(records))))> values;
  values.reserve(std::size(records));
  for (const auto& record : records) values.push_back(column_value(std::invoke(get, record)));
  return {name, unit, long_name, std::move(values), digits};
}

/// A column of one row: a number, a bool, a text or a Table, as column_value has it.
template <class Value>
[[nodiscard]] Column column_of_one(const std::string& name, const std::string& unit, const Value& value) {
  return {.name = name, .unit = unit, .values = std::vector{column_value(value)}};
}

/// A column before there are records: how it is described, where a record has its value, and what else
/// whoever lists it keeps with it.
template <class Record, class Also = std::monostate>
struct ColumnOf {
  struct Code {
    std::uint8_t (*of)(const Record&);
    CodeNames names;
  };
  const char* name;
  const char* unit;
  const char* long_name;
  std::variant<double Record::*, std::optional<double> Record::*, std::int64_t Record::*,
               std::optional<std::int64_t> Record::*, double (*)(const Record&), Code>
      get;
  const char* key = "";  ///< Column::key.
  Also also = {};

  /// Of codes the code.
  [[nodiscard]] std::optional<double> number(const Record& record) const {
    return std::visit(
        [&record](const auto& value) -> std::optional<double> {
          if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Code>) {
            return value.of(record);
          } else {
            return std::invoke(value, record);
          }
        },
        get);
  }
};

/// The column's values as that type; empty if they were of another.
template <class Values>
[[nodiscard]] Values& values_as(Column& column) {
  if (auto* const values = std::get_if<Values>(&column.values)) return *values;
  return column.values.template emplace<Values>();
}

/// Puts a value of each record in place of the column's values, whose memory is used again.
template <class Record, class Also>
void set_values(Column& column, const ColumnOf<Record, Also>& described,
                std::type_identity_t<std::span<const Record>> records) {
  const auto put = [records](auto& values, const auto& value_of) {
    values.clear();
    values.reserve(records.size());
    for (const Record& record : records) values.push_back(value_of(record));
  };
  std::visit(
      [&](const auto& get) {
        if constexpr (std::is_same_v<std::decay_t<decltype(get)>, typename ColumnOf<Record, Also>::Code>) {
          auto& [names, codes] = values_as<Codes>(column);
          names = get.names;
          put(codes, get.of);
        } else {
          const auto value_of = [&get](const Record& record) {
            return column_value(std::invoke(get, record));
          };
          put(values_as<std::vector<decltype(value_of(*records.begin()))>>(column), value_of);
        }
      },
      described.get);
}

template <class Record, class Also>
[[nodiscard]] Column column_of(const ColumnOf<Record, Also>& described,
                               std::type_identity_t<std::span<const Record>> records) {
  Column column{.name = described.name,
                .unit = described.unit,
                .long_name = described.long_name,
                .values = {},
                .key = described.key};
  set_values(column, described, records);
  return column;
}

/// The records as columns: a table, or a chunk of one.
[[nodiscard]] std::vector<Column> columns_of(const auto& described, const auto& records) {
  std::vector<Column> columns;
  for (const auto& each : described) columns.push_back(column_of(each, records));
  return columns;
}

/// Another chunk of them. REQUIRES: columns of columns_of.
void set_columns(std::vector<Column>& columns, const auto& described, const auto& records) {
  auto column = columns.begin();
  for (const auto& each : described) set_values(*column++, each, records);
}

}  // namespace hyrax
