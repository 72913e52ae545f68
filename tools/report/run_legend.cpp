#include "tools/report/run_legend.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace hyrax {
namespace {

// The lines below the plot, from left to right.
class Legend {
 public:
  explicit Legend(const RunPlot& plot) : canvas_(plot.canvas), y_(RunPlot::kTop + plot.height + 48) {}

  void heading(const std::string& words) { text(words); }
  void wall(const std::string& words, std::string_view colour) {
    make_room(words, 15);
    dot(5, 0.9, colour);
    x_ += 15;
    text(words);
  }
  void throws(const std::string& words) {
    make_room(words, 32);
    commands_ += arrow(canvas_, x_, y_, 24, 0);
    x_ += 32;
    text(words);
  }
  void line(const std::string& words, std::string_view dashes) {
    make_room(words, 32);
    commands_ += fmt::format("set arrow from {} to {} nohead lw 1.5 dt {} lc rgb '{}'\n",
                             screen(canvas_, x_, y_), screen(canvas_, x_ + 24, y_), dashes, style::kQuietInk);
    x_ += 32;
    text(words);
  }
  void beads(const std::string& words) {
    make_room(words, 30);
    for (const double dx : {3.0, 12.0, 21.0}) dot(dx, 0.5, style::kBeads);
    x_ += 30;
    text(words);
  }
  [[nodiscard]] const std::string& commands() const { return commands_; }

 private:
  static constexpr double kStart = RunPlot::kLeft + 14;
  static double width(const std::string& words) { return 6.7 * static_cast<double>(words.size()); }

  void make_room(const std::string& words, double sign) {
    constexpr double kLine = 20;
    if (x_ + sign + width(words) <= canvas_.width - style::kMargin) return;
    x_ = kStart;
    y_ += kLine;
  }
  void dot(double dx, double size, std::string_view colour) {
    commands_ += fmt::format("set label '' at {} point pt 7 ps {} lc rgb '{}'\n",
                             screen(canvas_, x_ + dx, y_), size, colour);
  }
  void text(const std::string& words) {
    constexpr double kGap = 18;
    commands_ += fmt::format("set label {} at {} left tc rgb '{}'\n", quoted(words), screen(canvas_, x_, y_),
                             style::kQuietInk);
    x_ += width(words) + kGap;
  }

  const Canvas& canvas_;
  double x_ = kStart;
  double y_;
  std::string commands_;
};

}  // namespace

std::string run_legend(const RunPlot& plot, const RunScene& scene) {
  Legend legend(plot);
  if (scene.contacts != WallCounts{}) legend.heading("contacts");
  for (std::size_t i = 0; i < kWalls.size(); ++i)
    if (const std::int64_t count = scene.contacts[kWalls[i]]; count > 0)
      legend.wall(fmt::format("{} {}", kWallNames[i], count), kWallColours[i]);
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
