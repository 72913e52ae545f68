// The columns of a sweep's result file: their names, types, and what is written into them.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sim/ensemble/ensemble.h"
#include "sim/scenario/sweep.h"

namespace hyrax {

enum class ColumnType : std::uint8_t { real, integer, seed, byte };

/// Rows of a part that are written at once, with their results (which columns of inputs do not need).
struct EnsembleRows {
  const Sweep& sweep;
  WorkPart part;
  std::int64_t first_row = 0;
  std::int64_t count = 0;
  std::span<const MemberResult> results;
};

struct EnsembleColumn {
  std::string group;  ///< "members" or "inputs".
  std::string name;
  std::string unit;  ///< Empty if there is none.
  std::string long_name;
  ColumnType type = ColumnType::real;
  std::size_t width = 1;  ///< Values of a row; a column of more has two dimensions.
  /// Writes the rows' values, in the memory type and row after row.
  std::function<void(const EnsembleRows& rows, std::byte* to)> fill;

  [[nodiscard]] std::string path() const { return group + "/" + name; }
  [[nodiscard]] std::size_t row_bytes() const { return width * (type == ColumnType::byte ? 1 : 8); }
};

/// What the sweep keeps and, after it, what it varies.
[[nodiscard]] std::vector<EnsembleColumn> columns_of(const Sweep& sweep);

[[nodiscard]] hid_t file_type(ColumnType type);
[[nodiscard]] hid_t memory_type(ColumnType type);

}  // namespace hyrax
