// Figures, tables and verdicts as JSON, which files of studies and the report page have.
#pragma once

#include <string>
#include <vector>

#include "sim/result/figure.h"
#include "sim/result/result.h"
#include "sim/result/table.h"
#include "tools/files/json.h"

namespace hyrax {

/// Everything of the figure. A number that is not given or missing is null.
[[nodiscard]] Json figure_json(const Figure& figure);

/// The figures of a list, each as of figure_json. A key that is missing has its default.
/// @param place of the list, for messages.
/// ERRORS: Failure(bad_input) "PLACE/0/title: must be a text" for what is not of its kind, unknown names,
/// series or rows whose lists have not the lengths that figure.h requires.
[[nodiscard]] std::vector<Figure> figures_of(const Json& json, const std::string& place);

/// A table column by column. Of more than `rows_max` rows the first; `row_count` is of all. An integer
/// beyond 2^53, which JavaScript would round, is text. REQUIRES: no column of tables.
[[nodiscard]] Json table_json(const Table& table, std::size_t rows_max = 5'000);

/// {"text": [sentence or table...], "broken": [sentence...]}.
[[nodiscard]] Json verdict_json(const Verdict& verdict);

}  // namespace hyrax
