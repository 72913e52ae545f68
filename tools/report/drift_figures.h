// Pictures of a run compared with the reference.
#pragma once

#include <string>
#include <vector>

#include "sim/reference/drift_run.h"
#include "sim/result/figure.h"

namespace hyrax {

/// Distance of the whole run from the exact fling; energy of run and reference against time, with the drift
/// in % of each arc's largest energy below; the three errors on a logarithmic scale; effective restitution of
/// the contacts with that of the model; the causes of energy drift, summed over time. Their suffixes:
/// -whole, -energy, -errors, -restitution, -drift-causes.
[[nodiscard]] std::vector<Figure> drift_figures(const DriftRun& run);

/// The paths of the figures that draw_drift_figures writes for a scenario of that name.
[[nodiscard]] std::vector<std::string> drift_figure_paths(const std::string& folder, const std::string& name);

/// Draws FOLDER/NAME + suffix + .svg, with the scenario's name; creates the folder. Returns the paths.
/// ERRORS: those of draw_figure (figure_svg.h).
std::vector<std::string> draw_drift_figures(const std::string& folder, const DriftRun& run);

}  // namespace hyrax
