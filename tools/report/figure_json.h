// Figures, tables and verdicts as the report page reads them.
#pragma once

#include "sim/result/figure.h"
#include "sim/result/result.h"
#include "sim/result/table.h"
#include "tools/files/json.h"

namespace hyrax {

/// Everything of the figure but its sizes in px. A number that is not given or missing is null.
[[nodiscard]] Json figure_json(const Figure& figure);

/// A table column by column. Of more than `rows_max` rows the first; `row_count` is of all. An integer
/// beyond 2^53, which JavaScript would round, is text. REQUIRES: no column of tables.
[[nodiscard]] Json table_json(const Table& table, std::size_t rows_max = 5'000);

/// {"text": [sentence or table...], "broken": [sentence...]}.
[[nodiscard]] Json verdict_json(const Verdict& verdict);

}  // namespace hyrax
