// A study's table as comma-separated values, for spreadsheets.
#pragma once

#include <string>

#include "sim/study/table.h"

namespace hyrax {

/// RFC 4180, but for lines that end as Unix ends them. A column's head is NAME_UNIT, as "speed_px_per_s";
/// numbers are shortest-round-trip, and one that does not exist is an empty field.
[[nodiscard]] std::string csv_text(const StudyTable& table);

}  // namespace hyrax
