// Many scenes at once: which scenario exercises, and which needs, which part of model and scene.
#pragma once

#include <string>
#include <vector>

#include "sim/result/table.h"
#include "sim/result/verdict.h"
#include "sim/study/needs/needs.h"

namespace hyrax {

/// The parts of the model, jitter, and the kinds of input.
[[nodiscard]] const std::vector<std::string>& coverage_columns();

/// What a scene needs of each of coverage_columns(): the most that it needs of any part of that kind.
[[nodiscard]] std::vector<Need> coverage_of(const SceneNeeds& scene);

/// Those of coverage_columns() that no scene exercises.
[[nodiscard]] std::vector<std::string> never_exercised(const std::vector<SceneNeeds>& scenes);

/// A row for each scene, a column for each of coverage_columns().
[[nodiscard]] Table coverage_table(const std::vector<SceneNeeds>& scenes);

/// The verdict's text: for each column, how many scenes exercise and need it.
[[nodiscard]] Verdict coverage_verdict(const std::vector<SceneNeeds>& scenes, double within_px);

}  // namespace hyrax
