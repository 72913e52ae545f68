// Pictures of a run compared with the reference.
#pragma once

#include <string>
#include <vector>

#include "sim/reference/drift.h"
#include "sim/reference/model.h"
#include "sim/reference/whole_run.h"
#include "sim/result/figure.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// A row, and the number of the arc that it belongs to.
struct DrawnRow {
  std::size_t arc = 0;
  RowErrors errors;
};

/// What the pictures show: the first arcs and contacts, and all or every K-th row of the arcs.
struct DriftPicture {
  const Scenario& scenario;
  double simulated_s = 0.0;
  const DriftSummary& summary;
  const std::vector<ArcErrors>& arcs;
  const std::vector<ImpactErrors>& contacts;
  const std::vector<DrawnRow>& rows;
  const WholeOutcome& whole;
  const std::vector<WholeRow>& whole_rows;  ///< All or every K-th row.
  const Model& model;
};

/// Distance of the whole run from the exact fling; energy of run and reference against time; energy drift of
/// each arc in % of the arc's largest energy; the three errors on a logarithmic scale; effective restitution
/// of the contacts with that of the model; the causes of energy drift, summed over time. Their suffixes:
/// -whole, -energy, -energy-drift, -errors, -restitution, -drift-causes.
[[nodiscard]] std::vector<Figure> drift_figures(const DriftPicture& picture);

/// The paths of the figures that draw_drift_figures writes for a scenario of that name.
[[nodiscard]] std::vector<std::string> drift_figure_paths(const std::string& folder, const std::string& name);

/// Draws FOLDER/NAME + suffix + .svg, with the scenario's name; creates the folder. Returns the paths.
/// ERRORS: those of draw_figure (gnuplot.h).
std::vector<std::string> draw_drift_figures(const std::string& folder, const DriftPicture& picture);

}  // namespace hyrax
