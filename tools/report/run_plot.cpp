#include "tools/report/run_plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hyrax {

RunPlot::RunPlot(const Box& wanted) {
  scale = std::min(kWidth / wanted.width_px(), kHeightMax / wanted.height_px());
  height = std::max(kHeightMin, std::round(wanted.height_px() * scale));
  canvas.height = kTop + height + kBottom;
  const double dx_px = (kWidth / scale - wanted.width_px()) / 2;
  const double dy_px = (height / scale - wanted.height_px()) / 2;
  view = {wanted.left_px - dx_px, wanted.top_px - dy_px, wanted.right_px + dx_px, wanted.bottom_px + dy_px};
}

std::string run_axes(const RunPlot& plot) {
  const double right = (RunPlot::kLeft + RunPlot::kWidth) / plot.canvas.width;
  const double bottom = (RunPlot::kTop + plot.height) / plot.canvas.height;
  return fmt::format(
      "set lmargin at screen {:.8f}\nset rmargin at screen {:.8f}\n"
      "set tmargin at screen {:.8f}\nset bmargin at screen {:.8f}\n"
      "set xrange [{:.10g}:{:.10g}]\nset yrange [{:.10g}:{:.10g}]\nset clip two\n"
      "set format xy '%.7g'\nset xtics out font ',12' offset 0,0.3\nset ytics out font ',12' offset 0.5,0\n"
      "set label 11 'px' at {} right font ',12' tc rgb '{}'\n",
      RunPlot::kLeft / plot.canvas.width, right, 1 - RunPlot::kTop / plot.canvas.height, 1 - bottom,
      plot.view.left_px, plot.view.right_px, plot.view.bottom_px, plot.view.top_px,
      screen(plot.canvas, RunPlot::kLeft - 10, RunPlot::kTop + plot.height + 21), style::kQuietInk);
}

std::string run_colour_bar(const RunPlot& plot, const RunPath& path) {
  if (!(path.speed_px_per_s_max > 0)) return "set cbrange [0:1]\nunset colorbox\n";
  constexpr double kWidth = 10;
  constexpr double kRoomForUnit = 22;
  const double x = RunPlot::kLeft + RunPlot::kWidth + 14;
  const double bottom = RunPlot::kTop + plot.height;
  return fmt::format(
      "{}set cbrange [{:.6g}:{:.6g}]\nset colorbox user origin {} size screen {:.5f},{:.5f} noborder\n"
      "set cbtics scale 0 font ',12' offset -0.5,0\n"
      "set label 10 'speed, px/s' at {} right font ',12' tc rgb '{}'\n",
      path.speed_px_per_s_low > 0 ? "set logscale cb\n" : "", path.speed_px_per_s_low,
      path.speed_px_per_s_max, screen(plot.canvas, x, bottom), kWidth / plot.canvas.width,
      (plot.height - kRoomForUnit) / plot.canvas.height,
      screen(plot.canvas, plot.canvas.width - style::kMargin + 8, RunPlot::kTop + 4), style::kQuietInk);
}

}  // namespace hyrax
