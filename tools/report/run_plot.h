// The canvas of a run's picture: the plot to scale, axes, colour bar and legend.
#pragma once

#include <string>
#include <string_view>

#include "tools/report/figure_style.h"
#include "tools/report/run_scene.h"

namespace hyrax {

struct RunPlot {
  static constexpr double kLeft = 62;  ///< Of the plot on the canvas, in px of the SVG, as all that follow.
  static constexpr double kTop = 78;
  static constexpr double kBottom = 80;  ///< Below the plot: axis and legend.
  static constexpr double kWidth = 812;
  static constexpr double kHeightMin = 150;
  static constexpr double kHeightMax = 600;

  /// Fits the view into the plot; a narrow one gets blank space on both sides.
  explicit RunPlot(const Box& wanted);

  Canvas canvas;
  Box view;             ///< What the plot shows.
  double height = 0.0;  ///< Of the plot.
  double scale = 0.0;   ///< px of the SVG for one px of the window, in x and in y.

  [[nodiscard]] double x(double x_px) const { return kLeft + (x_px - view.left_px) * scale; }
  [[nodiscard]] double y(double y_px) const { return kTop + (y_px - view.top_px) * scale; }
  /// A place in the window, as gnuplot reads a place on the canvas.
  [[nodiscard]] std::string at(double x_px, double y_px) const { return screen(canvas, x(x_px), y(y_px)); }
};

/// The commands that set margins, ranges and tics.
[[nodiscard]] std::string run_axes(const RunPlot& plot);

/// The commands that set the range of speeds and draw the colour bar beside the plot; no bar if nothing
/// moves.
[[nodiscard]] std::string run_colour_bar(const RunPlot& plot, const RunPath& path);

inline constexpr std::string_view kMovedDashes = "(4,4)";
inline constexpr std::string_view kUnrecordedDashes = "(1,5)";

/// The commands that draw the legend below the plot, with entries only for what the picture shows.
[[nodiscard]] std::string run_legend(const RunPlot& plot, const RunScene& scene);

}  // namespace hyrax
