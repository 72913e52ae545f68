// Many scenarios at once: which of them exercises, and which needs, which part of the model and which input.
#pragma once

#include <string>
#include <vector>

#include "sim/result/result.h"
#include "sim/result/table.h"
#include "sim/study/needs/needs.h"

namespace hyrax {

/// The parts of the model, jitter, and the kinds of input.
[[nodiscard]] const std::vector<std::string>& coverage_columns();

/// What a scenario needs of each of coverage_columns(): the most that it needs of any part of that kind.
[[nodiscard]] std::vector<Need> coverage_of(const ScenarioNeeds& needs);

/// Those of coverage_columns() that no scenario exercises.
[[nodiscard]] std::vector<std::string> never_exercised(const std::vector<ScenarioNeeds>& scenarios);

/// A row for each scenario, a column for each of coverage_columns().
[[nodiscard]] Table coverage_table(const std::vector<ScenarioNeeds>& scenarios);

/// The paths of the core's step that any of them takes.
[[nodiscard]] std::set<std::int32_t> paths_taken(const std::vector<ScenarioNeeds>& scenarios);

/// The verdict's text: for each column, how many scenarios exercise and need it.
[[nodiscard]] Verdict coverage_verdict(const std::vector<ScenarioNeeds>& scenarios, double within_px);

}  // namespace hyrax
