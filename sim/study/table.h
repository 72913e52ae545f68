// What every study comes to: tables of plain columns, with units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace hyrax {

/// A quantity, one value a row.
struct StudyColumn {
  std::string name;       ///< snake_case, without its unit.
  std::string unit;       ///< "px", "px/s", "1" for a pure number; empty for text and names.
  std::string long_name;  ///< What it is, in words.
  /// A value that does not exist is a NaN.
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>> values;
};

struct StudyTable {
  std::string name;  ///< snake_case; of one study's tables each has another.
  std::string long_name;
  std::vector<StudyColumn> columns;  ///< All of one length.
};

[[nodiscard]] std::size_t length(const StudyColumn& column);

/// Rows of the table; 0 without columns. REQUIRES: all columns have one length.
[[nodiscard]] std::size_t row_count(const StudyTable& table);

}  // namespace hyrax
