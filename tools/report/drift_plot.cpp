#include "tools/report/drift_plot.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "tools/report/run_legend.h"

namespace hyrax {
namespace {

constexpr double kLeft = 76;  // Of the plot on the canvas, in px of the SVG, as all that follow.
constexpr double kRight = 28;
constexpr double kTop = 104;
constexpr double kBottom = 84;
constexpr double kLegend = 26;  // From the lower edge.

constexpr std::string_view kBand = "#eaeef2";
constexpr std::size_t kArcsMarkedMax = 80;

std::string note_of(const DriftPicture& picture) {
  if (picture.arcs.empty()) return "";
  const DriftSummary& summary = picture.summary;
  if (summary.arcs > static_cast<std::int64_t>(picture.arcs.size()))
    return fmt::format("the first {} of {} arcs", picture.arcs.size(), summary.arcs);
  return fmt::format("{} arc{}, {} contact{}", summary.arcs, summary.arcs == 1 ? "" : "s", summary.contacts,
                     summary.contacts == 1 ? "" : "s");
}

}  // namespace

std::string_view wall_colour(Wall wall) { return kWallColours[wall_index(wall)]; }

std::string power_of_ten(int exponent) {
  constexpr std::array<std::string_view, 10> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kRaised[static_cast<std::size_t>(digit - '0')];
  return text;
}

DriftPlot::DriftPlot(const DriftPicture& picture, std::string_view subtitle, std::string_view x_label,
                     std::string_view y_label)
    : picture_(picture), legend_x_(kLeft) {
  const double bottom = canvas_.height - kBottom;
  const double right = canvas_.width - kRight;
  commands_ = figure_head(canvas_, picture.scenario.name, subtitle);
  add(fmt::format("set label 3 {} at {} right tc rgb '{}'\n", quoted(note_of(picture)),
                  screen(canvas_, right, 34), style::kQuietInk));
  add(fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
      "set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n",
      kLeft / canvas_.width, right / canvas_.width, 1 - kTop / canvas_.height, 1 - bottom / canvas_.height));
  add(fmt::format(
      "set object 2 rectangle from graph 0,0 to graph 1,1 behind fs solid 1 noborder fc rgb '{}'\n",
      style::kPaper));
  add("set xtics out font ',12' offset 0,0.3\nset ytics out font ',12' offset 0.5,0\n");
  add(fmt::format("set grid ytics back lt 1 lw 1 lc rgb '{}'\n", style::kHairline));
  add(fmt::format("set label 10 {} at {} left font ',12' tc rgb '{}'\n", quoted(y_label),
                  screen(canvas_, style::kMargin, kTop - 20), style::kQuietInk));
  add(fmt::format("set label 11 {} at {} right font ',12' tc rgb '{}'\n", quoted(x_label),
                  screen(canvas_, right, bottom + 36), style::kQuietInk));
}

void DriftPlot::mark_arcs() {
  const std::vector<ArcErrors>& arcs = picture_.arcs;
  if (picture_.rows.empty()) return add("set xrange [0:1]\n");
  const double end_s = picture_.rows.back().errors.t_s;
  add(fmt::format("set xrange [0:{:.10g}]\n", end_s > 0.0 ? end_s : 1.0));
  if (arcs.size() > kArcsMarkedMax) return;
  std::array<bool, 4> has_wall{};
  std::size_t row = 0;
  for (std::size_t arc = 0; arc < arcs.size(); ++arc) {
    if (row == picture_.rows.size()) break;
    const double from_s = picture_.rows[row].errors.t_s;
    while (row < picture_.rows.size() && picture_.rows[row].arc == arc) ++row;
    const double to_s = picture_.rows[row - (row > 0)].errors.t_s;
    if (arc % 2 == 1)
      add(
          fmt::format("set object {} rectangle from first {:.10g}, graph 0 to first {:.10g}, graph 1 behind "
                      "fs solid 1 noborder fc rgb '{}'\n",
                      10 + arc, from_s, to_s, kBand));
    const auto wall = wall_of(arcs[arc].ended_by);
    if (!wall) continue;
    has_wall[wall_index(*wall)] = true;
    add(fmt::format("set label '' at first {:.10g}, graph 1.035 point pt 7 ps 0.7 lc rgb '{}'\n", to_s,
                    wall_colour(*wall)));
  }
  if (arcs.size() > 1) explain_band("every other arc");
  for (const Wall wall : kWalls)
    if (has_wall[wall_index(wall)]) explain_dot(kWallNames[wall_index(wall)], wall_colour(wall));
}

void DriftPlot::add_block(std::string_view name, const std::string& lines) {
  add(fmt::format("${} << EOD\n{}EOD\n", name, lines.empty() ? "NaN NaN NaN\n" : lines));
}

void DriftPlot::explain_line(std::string_view words, std::string_view colour, double width,
                             std::string_view dashes) {
  const double y = canvas_.height - kLegend;
  add(fmt::format("set arrow from {} to {} nohead lw {} dt {} lc rgb '{}'\n", screen(canvas_, legend_x_, y),
                  screen(canvas_, legend_x_ + 24, y), width, dashes, colour));
  explain(words, 32);
}

void DriftPlot::explain_dot(std::string_view words, std::string_view colour) {
  add(fmt::format("set label '' at {} point pt 7 ps 0.7 lc rgb '{}'\n",
                  screen(canvas_, legend_x_ + 4, canvas_.height - kLegend), colour));
  explain(words, 14);
}

void DriftPlot::explain_band(std::string_view words) {
  const double y = canvas_.height - kLegend;
  add(fmt::format("set object 3 rectangle from {} to {} fs solid 1 border lc rgb '{}' fc rgb '{}'\n",
                  screen(canvas_, legend_x_, y - 7), screen(canvas_, legend_x_ + 24, y + 7), style::kHairline,
                  kBand));
  explain(words, 32);
}

void DriftPlot::explain(std::string_view words, double sign) {
  constexpr double kLetter = 6.7;
  constexpr double kGap = 18;
  add(fmt::format("set label {} at {} left tc rgb '{}'\n", quoted(words),
                  screen(canvas_, legend_x_ + sign, canvas_.height - kLegend), style::kQuietInk));
  legend_x_ += sign + kLetter * static_cast<double>(words.size()) + kGap;
}

std::string DriftPlot::script(const std::string& plot_command) const {
  return commands_ + plot_command + "\n";
}

std::string DriftPlot::script_of_nothing(std::string_view why) const {
  return commands_ + fmt::format(
                         "unset xtics\nunset ytics\nunset logscale\nset yrange [0:1]\nset xrange [0:1]\n"
                         "set label {} at graph 0.5,0.5 center tc rgb '{}'\nplot NaN notitle\n",
                         quoted(why), style::kQuietInk);
}

}  // namespace hyrax
