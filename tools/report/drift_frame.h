// The frame that the pictures of a run's errors share: the run's name, time, bands for arcs.
#pragma once

#include <string>
#include <string_view>

#include "tools/report/drift_figures.h"
#include "tools/report/plot_frame.h"

namespace hyrax {

/// @param subtitle what the picture shows; @param y_label with its unit, above the axis.
[[nodiscard]] PlotFrame drift_frame(const DriftPicture& picture, std::string_view subtitle,
                                    std::string_view x_label, std::string_view y_label);

/// Time from 0 to the end of the last arc; every other arc on a darker band, and a dot at the top for
/// every wall that ended one. Of more arcs than can be told apart, neither.
void mark_arcs(PlotFrame& frame, const DriftPicture& picture);

[[nodiscard]] std::string_view wall_colour(Wall wall);

}  // namespace hyrax
