// Draws any figure as an SVG picture.
#pragma once

#include <string>

#include "sim/result/figure.h"

namespace hyrax {

/// The text of an SVG file. Equal figures have equal texts. The legend is above the plots or the grid, the
/// remarks are below. A figure without data says "nothing to show".
/// REQUIRES: each series has as many y as x, and as many of each of its other columns or none.
[[nodiscard]] std::string figure_svg(const Figure& figure);

/// The same without title, subtitle, note and remarks as part of an HTML page: plots in three widths, of
/// which results.css shows the one whose text has its size there; a grid or list as wide as it is.
[[nodiscard]] std::string figure_html(const Figure& figure);

/// Draws it into the file at `path`. ERRORS: those of write_text_file.
void draw_figure(const std::string& path, const Figure& figure);

}  // namespace hyrax
