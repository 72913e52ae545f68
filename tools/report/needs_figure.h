// What scenes need, as pictures.
#pragma once

#include <string>
#include <vector>

#include "sim/study/needs/needs.h"

namespace hyrax {

/// gnuplot's script: how far the path of one scene moves without each part, on a logarithmic scale, the
/// tolerance as a line.
[[nodiscard]] std::string needs_script(const SceneNeeds& scene, double within_px);

/// gnuplot's script: which scenario exercises and needs what, as a table of fields.
[[nodiscard]] std::string coverage_script(const std::vector<SceneNeeds>& scenes, double within_px);

}  // namespace hyrax
