// What scenes need, as tables.
#pragma once

#include <string>
#include <vector>

#include "sim/study/needs/needs.h"
#include "sim/result/table.h"

namespace hyrax {

[[nodiscard]] std::string_view name_of(Need need);

/// What a coverage table tells of: the parts, jitter, and the kinds of input.
[[nodiscard]] const std::vector<std::string>& coverage_columns();

/// The most that a scene needs of each of these: of two hitches the needed one counts.
[[nodiscard]] std::vector<Need> coverage_of(const SceneNeeds& scene);

/// parts, coverage, control, cheapest.
[[nodiscard]] std::vector<Table> tables_of(const std::vector<SceneNeeds>& scenes, double within_px);

}  // namespace hyrax
