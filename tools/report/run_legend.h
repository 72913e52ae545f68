// The legend of a run's picture, and the colours and dashes that it explains.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "tools/report/figure_style.h"
#include "tools/report/run_plot.h"
#include "tools/report/run_scene.h"

namespace hyrax {

/// In the order of kWalls.
inline constexpr std::array<std::string_view, 4> kWallColours = {style::kSkyBlue, style::kVermilion,
                                                                 style::kPurple, style::kOrange};

inline constexpr std::string_view kMovedDashes = "(4,4)";
inline constexpr std::string_view kUnrecordedDashes = "(1,5)";

/// The commands that draw the legend below the plot: only what the picture has.
[[nodiscard]] std::string run_legend(const RunPlot& plot, const RunScene& scene);

}  // namespace hyrax
