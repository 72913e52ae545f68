#include "tools/report/plot_frame.h"

#include <array>
#include <cstdlib>

#include <fmt/format.h>

namespace hyrax {
namespace {

constexpr double kLeft = 76;  // Of the plot on the canvas, in px of the SVG, as all that follow.
constexpr double kRight = 28;
constexpr double kTop = 118;
constexpr double kBottom = 92;
constexpr double kLegend = 26;  // From the lower edge.
constexpr double kSign = 32;    // From a sign of the legend to its words.
constexpr double kDot = 14;

}  // namespace

PlotFrame::PlotFrame(std::string_view title, std::string_view subtitle, std::string_view x_label,
                     std::string_view y_label, Canvas canvas)
    : canvas_(canvas), legend_x_(kLeft) {
  const double bottom = canvas_.height - kBottom;
  const double right = canvas_.width - kRight;
  commands_ = figure_head(canvas_, title, subtitle);
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
                  screen(canvas_, style::kMargin, kTop - 32), style::kQuietInk));
  add(fmt::format("set label 11 {} at {} right font ',12' tc rgb '{}'\n", quoted(x_label),
                  screen(canvas_, right, bottom + 40), style::kQuietInk));
}

void PlotFrame::note(std::string_view words) {
  add(fmt::format("set label 3 {} at {} right tc rgb '{}'\n", quoted(words),
                  screen(canvas_, canvas_.width - kRight, 34), style::kQuietInk));
}

void PlotFrame::add_block(std::string_view name, const std::string& lines) {
  add(fmt::format("${} << EOD\n{}EOD\n", name, lines.empty() ? "NaN NaN NaN NaN\n" : lines));
}

void PlotFrame::use_rate_axis(double low_hz, double high_hz) {
  add(fmt::format(
      "set logscale x\nset xrange [{}:{}]\nset xtics (20, 24, 30, 40, 60, 75, 90, 120, 144, 165, 240, 360, "
      "500, 1000)\n",
      low_hz, high_hz));
}

void PlotFrame::mark(double x, std::string_view words) {
  add(fmt::format(
      "set arrow from first {0:.8g}, graph 0 to first {0:.8g}, graph 1 nohead front lw 1.5 dt (6,4) lc rgb "
      "'{1}'\n",
      x, style::kInk));
  add(fmt::format("set label {} at first {:.8g}, graph 1.035 center font ',11' tc rgb '{}'\n", quoted(words),
                  x, style::kInk));
}

void PlotFrame::explain_line(std::string_view words, std::string_view colour, double width,
                             std::string_view dashes) {
  const double y = canvas_.height - kLegend;
  add(fmt::format("set arrow from {} to {} nohead lw {} dt {} lc rgb '{}'\n", screen(canvas_, legend_x_, y),
                  screen(canvas_, legend_x_ + 24, y), width, dashes, colour));
  explain(words, kSign);
}

void PlotFrame::explain_area(std::string_view words, std::string_view colour) {
  const double y = canvas_.height - kLegend;
  add(fmt::format("set object {} rectangle from {} to {} fs solid 1 border lc rgb '{}' fc rgb '{}'\n",
                  next_object_++, screen(canvas_, legend_x_, y - 7), screen(canvas_, legend_x_ + 24, y + 7),
                  style::kHairline, colour));
  explain(words, kSign);
}

void PlotFrame::explain_dot(std::string_view words, std::string_view colour, int point_type) {
  add(fmt::format("set label '' at {} point pt {} ps 0.7 lc rgb '{}'\n",
                  screen(canvas_, legend_x_ + 4, canvas_.height - kLegend), point_type, colour));
  explain(words, kDot);
}

void PlotFrame::explain(std::string_view words, double sign_width) {
  constexpr double kLetter = 7.2;  // Of the widest of the fonts.
  constexpr double kGap = 18;
  add(fmt::format("set label {} at {} left tc rgb '{}'\n", quoted(words),
                  screen(canvas_, legend_x_ + sign_width, canvas_.height - kLegend), style::kQuietInk));
  legend_x_ += sign_width + kLetter * static_cast<double>(words.size()) + kGap;
}

std::string PlotFrame::script_of_nothing(std::string_view why) const {
  return commands_ + fmt::format(
                         "unset xtics\nunset ytics\nunset logscale\nset yrange [0:1]\nset xrange [0:1]\n"
                         "set label {} at graph 0.5,0.5 center tc rgb '{}'\nplot NaN notitle\n",
                         quoted(why), style::kQuietInk);
}

std::string power_of_ten(int exponent) {
  constexpr std::array<std::string_view, 10> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kRaised[static_cast<std::size_t>(digit - '0')];
  return text;
}

}  // namespace hyrax
