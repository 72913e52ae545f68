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

/// Their files in a folder, for a scenario of that name.
[[nodiscard]] std::vector<std::string> drift_figure_paths(const std::string& folder, const std::string& name);

}  // namespace hyrax
