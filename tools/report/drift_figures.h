// Pictures of a run compared with the reference.
#pragma once

#include <string>
#include <vector>

#include "sim/reference/drift.h"
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
};

// The gnuplot scripts. The same picture gives the same text.

/// Energy of run and reference against time, the arcs marked.
[[nodiscard]] std::string energy_figure_script(const DriftPicture& picture);
/// Energy drift of each arc against time, in % of the arc's largest energy.
[[nodiscard]] std::string energy_drift_figure_script(const DriftPicture& picture);
/// The three errors against time, on a logarithmic scale.
[[nodiscard]] std::string errors_figure_script(const DriftPicture& picture);
/// Effective restitution of the contacts in order, with the 0.6 of the paper.
[[nodiscard]] std::string restitution_figure_script(const DriftPicture& picture);

/// The paths of the figures that draw_drift_figures writes for a scenario of that name.
[[nodiscard]] std::vector<std::string> drift_figure_paths(const std::string& folder, const std::string& name);

/// Draws FOLDER/NAME-energy.svg, -energy-drift.svg, -errors.svg and -restitution.svg, with the scenario's
/// name; creates the folder. Returns the paths. ERRORS: those of draw_figure (gnuplot.h).
std::vector<std::string> draw_drift_figures(const std::string& folder, const DriftPicture& picture);

}  // namespace hyrax
