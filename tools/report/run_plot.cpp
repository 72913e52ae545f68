#include "tools/report/run_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/figure_body.h"

namespace hyrax {
namespace {

// The lines below the plot, from left to right.
class Legend {
 public:
  explicit Legend(const RunPlot& plot) : canvas_(plot.canvas), y_(RunPlot::kTop + plot.height + 48) {}

  void heading(const std::string& label) { text(label); }
  void wall(const std::string& label, std::string_view colour) {
    make_room(label, 15);
    dot(5, 0.9, colour);
    x_ += 15;
    text(label);
  }
  void throws(const std::string& label) {
    make_room(label, 32);
    commands_ += arrow(canvas_, x_, y_, 24, 0);
    x_ += 32;
    text(label);
  }
  void line(const std::string& label, std::string_view dashes) {
    make_room(label, 32);
    commands_ += fmt::format("set arrow from {} to {} nohead lw 1.5 dt {} lc rgb '{}'\n",
                             screen(canvas_, x_, y_), screen(canvas_, x_ + 24, y_), dashes, style::kQuietInk);
    x_ += 32;
    text(label);
  }
  void beads(const std::string& label) {
    make_room(label, 30);
    for (const double dx : {3.0, 12.0, 21.0}) dot(dx, 0.5, style::kBeads);
    x_ += 30;
    text(label);
  }
  [[nodiscard]] const std::string& commands() const { return commands_; }

 private:
  static constexpr double kStart = RunPlot::kLeft + 14;
  static double width(const std::string& label) { return 6.7 * static_cast<double>(label.size()); }

  void make_room(const std::string& label, double sign) {
    constexpr double kLine = 20;
    if (x_ + sign + width(label) <= canvas_.width - style::kMargin) return;
    x_ = kStart;
    y_ += kLine;
  }
  void dot(double dx, double size, std::string_view colour) {
    commands_ += fmt::format("set label '' at {} point pt 7 ps {} lc rgb '{}'\n",
                             screen(canvas_, x_ + dx, y_), size, colour);
  }
  void text(const std::string& label) {
    constexpr double kGap = 18;
    commands_ += fmt::format("set label {} at {} left tc rgb '{}'\n", in_quotes(label),
                             screen(canvas_, x_, y_), style::kQuietInk);
    x_ += width(label) + kGap;
  }

  const Canvas& canvas_;
  double x_ = kStart;
  double y_;
  std::string commands_;
};

}  // namespace

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
  constexpr double kBarWidth = 10;
  constexpr double kRoomForUnit = 22;
  const double x = RunPlot::kLeft + RunPlot::kWidth + 14;
  const double bottom = RunPlot::kTop + plot.height;
  return fmt::format(
      "{}set cbrange [{:.6g}:{:.6g}]\nset colorbox user origin {} size screen {:.5f},{:.5f} noborder\n"
      "set cbtics scale 0 font ',12' offset -0.5,0\n"
      "set label 10 'speed, px/s' at {} right font ',12' tc rgb '{}'\n",
      path.speed_px_per_s_low > 0 ? "set logscale cb\n" : "", path.speed_px_per_s_low,
      path.speed_px_per_s_max, screen(plot.canvas, x, bottom), kBarWidth / plot.canvas.width,
      (plot.height - kRoomForUnit) / plot.canvas.height,
      screen(plot.canvas, plot.canvas.width - style::kMargin + 8, RunPlot::kTop + 4), style::kQuietInk);
}

std::string run_legend(const RunPlot& plot, const RunScene& scene) {
  Legend legend(plot);
  if (scene.contacts != WallCounts{}) legend.heading("contacts");
  for (std::size_t i = 0; i < kWalls.size(); ++i)
    if (const std::int64_t count = scene.contacts[kWalls[i]]; count > 0)
      legend.wall(fmt::format("{} {}", kWallNames[i], count), colour_of(kWallTones[i]));
  if (scene.throws.size() == 1)
    legend.throws(fmt::format("thrown at {:.4g} px/s", speed_px_per_s(scene.throws.front().velocity)));
  if (scene.throws.size() > 1) legend.throws("thrown");
  const auto has = [&scene](StrokeKind kind) {
    return std::any_of(scene.path.strokes.begin(), scene.path.strokes.end(),
                       [kind](const Stroke& stroke) { return stroke.kind == kind; });
  };
  if (has(StrokeKind::moved)) legend.line("not flown", kMovedDashes);
  if (has(StrokeKind::unrecorded)) legend.line("not recorded", kUnrecordedDashes);
  if (!scene.path.beads.empty())
    legend.beads(scene.path.frames_per_bead == 1
                     ? "every frame"
                     : fmt::format("every {} frames", scene.path.frames_per_bead));
  return legend.commands();
}

}  // namespace hyrax
