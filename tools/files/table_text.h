// A table as text: for people, as comma-separated values, and as JSON.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sim/result/table.h"
#include "tools/files/json.h"

namespace hyrax {

/// Aligned columns under their names and units, each line indented by two blanks; the units have a line of
/// their own where heads in one line would take more than 100 columns. Numbers have the column's
/// significant digits, a missing one is "-". The last columns that do not fit in `width_max` letters are left
/// out, and counted. REQUIRES: no column of tables.
[[nodiscard]] std::string aligned_text(const Table& table,
                                       std::size_t width_max = std::numeric_limits<std::size_t>::max());

/// What aligned_text is made of: a column's name with its unit, its values, and whether they are aligned as
/// text is.
[[nodiscard]] std::string printed_head(const Column& column);
[[nodiscard]] std::vector<std::string> printed_values(const Column& column);
[[nodiscard]] bool is_text(const Column& column);

/// RFC 4180, except that lines end as Unix ends them. A column's head is NAME_UNIT, as "speed_px_per_s";
/// numbers are shortest-round-trip, a missing one is an empty field. REQUIRES: no column of tables.
[[nodiscard]] std::string csv_text(const Table& table);

/// The table in its JsonForm; keys are Column::key or the heads of csv_text in lower case, a missing number
/// is null. REQUIRES: the form is not `members`, which has no value of its own; see add_members.
[[nodiscard]] Json json_of(const Table& table);

[[nodiscard]] std::string key_of(const Column& column);

/// Adds each table to an object: its first row's values if its form is `members`, else one member of its
/// name.
void add_members(Json::Object& object, const std::vector<Table>& tables);

}  // namespace hyrax
