// gnuplot's script of any figure.
#pragma once

#include <string>

#include "sim/result/figure.h"

namespace hyrax {

/// Ends in what draw_figure (gnuplot.h) takes. Equal figures have equal scripts. The legend is below the
/// plots or the grid, then the remarks, a line each or two. A figure without data says "nothing to show".
/// REQUIRES: each series has as many y as x, and as many of each of its other columns or none.
[[nodiscard]] std::string figure_script(const Figure& figure);

}  // namespace hyrax
