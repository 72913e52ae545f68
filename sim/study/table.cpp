#include "sim/study/table.h"

#include <algorithm>
#include <cassert>

namespace hyrax {

std::size_t length(const StudyColumn& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
}

std::size_t row_count(const StudyTable& table) {
  if (table.columns.empty()) return 0;
  const std::size_t rows = length(table.columns.front());
  assert(std::all_of(table.columns.begin(), table.columns.end(),
                     [rows](const StudyColumn& column) { return length(column) == rows; }));
  return rows;
}

}  // namespace hyrax
