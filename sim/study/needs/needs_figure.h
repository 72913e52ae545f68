// The figures of the study needs.
#pragma once

#include <string>
#include <vector>

#include "sim/result/figure.h"
#include "sim/study/needs/needs.h"

namespace hyrax {

/// How far the path of one scenario moves without each part: bars on a logarithmic axis, the tolerance as a
/// mark.
[[nodiscard]] Figure needs_figure(const ScenarioNeeds& needs, double within_px);

/// Which scenario exercises and needs which part: a grid of colours.
[[nodiscard]] Figure coverage_figure(const std::vector<ScenarioNeeds>& scenarios, double within_px);

/// "941 px"; "without bound" if it is infinite.
[[nodiscard]] std::string length_text(double length_px);

}  // namespace hyrax
