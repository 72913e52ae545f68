// The two bodies that a figure may have.
#pragma once

#include <vector>

#include "tools/report/svg.h"

namespace hyrax {

/// Of the sheet that a body needs, in px.
[[nodiscard]] double sheet_width(const std::vector<Plot>& plots);
[[nodiscard]] double sheet_width(const Grid& grid);

/// Draws a body from `top` on; returns where it ends.
double draw_body(Svg& svg, const std::vector<Plot>& plots, double width, double top);
double draw_body(Svg& svg, const Grid& grid, double width, double top);

/// Of its area: a line or a text over a band of a hue stays readable.
[[nodiscard]] double opacity_of(const Look& look);

/// A line or several of entries, each with a sign, from `top` on; returns where they end.
double draw_legend(Svg& svg, const std::vector<LegendEntry>& entries, double width, double top);

}  // namespace hyrax
