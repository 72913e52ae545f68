#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include <fmt/format.h>

#include "tools/report/figure_body.h"
#include "tools/report/label_placer.h"

namespace hyrax {
namespace {

constexpr double kLeft = 76;  // All in px of the SVG.
constexpr double kRight = 28;
constexpr double kBelow = 52;  // From the plots to the legend: tics and the label of x.
constexpr double kWidth = 960;
constexpr double kHeight = 270;
constexpr double kWidthOfSeveral = 1180;
constexpr double kHeightOfSeveral = 422;
constexpr double kCategory = 26;
constexpr int kTicsMax = 9;

struct PlotBox {
  double left = 0.0;
  double right = 0.0;
  double bottom = 0.0;
};

struct AxisRange {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool is_empty() const { return low > high; }
};

// A value as it is drawn on the axis: on a logarithmic one, zero is drawn at its own line.
double drawn(const Axis& axis, double value) {
  return std::isnan(axis.zero_at) || std::isnan(value) ? value : std::max(value, axis.zero_at);
}

// All values of one axis: its own and those of columns that spread along it.
template <class Values>
AxisRange range_of(const Axis& axis, const Plot& plot, const Values& values) {
  AxisRange range;
  for (const Series& series : plot.series)
    for (const std::vector<double>* const column : values(series))
      for (const double value : *column)
        if (!axis.is_logarithmic || drawn(axis, value) > 0.0) range.include(drawn(axis, value));
  return range;
}

// The axis's ends, where they are not given: those of the data and some space.
AxisRange ends_of(const Axis& axis, AxisRange range) {
  if (!axis.categories.empty()) return {-0.5, static_cast<double>(axis.categories.size()) - 0.5};
  if (range.is_empty()) range = axis.is_logarithmic ? AxisRange{1.0, 10.0} : AxisRange{0.0, 1.0};
  const double space = 0.05 * (range.high - range.low) + (range.high > range.low ? 0.0 : 0.5);
  if (std::isnan(axis.low))
    range.low = axis.is_logarithmic ? range.low / 1.6 : range.low - space;
  else
    range.low = axis.low;
  if (std::isnan(axis.high))
    range.high = axis.is_logarithmic ? range.high * 1.6 : range.high + space;
  else
    range.high = axis.high;
  return range;
}

// Ticks at powers of ten, above the line of zeros if there is one.
std::string powers_of_ten(const Axis& axis, const AxisRange& ends) {
  const int low = static_cast<int>(std::ceil(std::log10(ends.low) - 1e-9));
  const int high = static_cast<int>(std::floor(std::log10(ends.high) + 1e-9));
  const int every = 1 + std::max(0, high - low - 1) / kTicsMax;
  std::string tics;
  for (int exponent = low; exponent <= high; ++exponent)
    if (exponent % every == 0 && !(std::pow(10.0, exponent) <= axis.zero_at * 1.01))
      tics += fmt::format("{}'{}' 1e{}", tics.empty() ? "" : ", ", power_of_ten(exponent), exponent);
  return tics;
}

std::string tics_of(const Axis& axis, const AxisRange& ends) {
  std::string tics;
  for (const Tick& tick : axis.ticks)
    tics += fmt::format("{}{} {:.8g}", tics.empty() ? "" : ", ", in_quotes(tick.text), tick.at);
  for (std::size_t index = 0; index < axis.categories.size(); ++index)
    tics += fmt::format("{}{} {}", index == 0 ? "" : ", ", in_quotes(axis.categories[index]), index);
  if (tics.empty() && axis.is_logarithmic) tics = powers_of_ten(axis, ends);
  return tics;
}

std::string axis_script(char name, const Axis& axis, const AxisRange& ends) {
  const bool is_downwards = axis.is_reversed || (name == 'y' && !axis.categories.empty());
  std::string script = axis.is_logarithmic ? fmt::format("set logscale {}\n", name) : std::string();
  script += fmt::format("set {}range [{:.8g}:{:.8g}]\n", name, is_downwards ? ends.high : ends.low,
                        is_downwards ? ends.low : ends.high);
  if (axis.decimals >= 0) script += fmt::format("set format {} '%.{}f'\n", name, axis.decimals);
  const std::string tics = tics_of(axis, ends);
  if (tics.empty())
    script += fmt::format("set {}tics autofreq\n", name);
  else
    script += fmt::format("set {}tics {}({})\n", name, axis.categories.empty() ? "" : "scale 0 ", tics);
  if (!std::isnan(axis.zero_at)) script += fmt::format("set {}tics add ('0' {:.6g})\n", name, axis.zero_at);
  return script;
}

// Widens one of the axes, to both sides.
void make_scales_equal(AxisRange& x, AxisRange& y, const PlotBox& box) {
  const double x_per_px = (x.high - x.low) / (box.right - box.left);
  const double y_per_px = (y.high - y.low) / (box.bottom - kBodyTop);
  AxisRange& widened = x_per_px < y_per_px ? x : y;
  const double factor = std::max(x_per_px, y_per_px) / std::min(x_per_px, y_per_px);
  const double space = 0.5 * (factor - 1.0) * (widened.high - widened.low);
  widened.low -= space;
  widened.high += space;
}

bool is_empty(const Plot& plot) {
  return std::all_of(plot.series.begin(), plot.series.end(),
                     [](const Series& series) { return series.x.empty(); });
}

// Instead of axes without points. The only tick is beyond the end of its axis: `unset xtics` would also
// unset how the next plot's look.
std::string empty_script(std::string_view reason) {
  return fmt::format(
      "set xtics ('' 2)\nset ytics ('' 2)\nset xrange [0:1]\nset yrange [0:1]\n"
      "set label {} at graph 0.5,0.5 center tc rgb '{}'\nplot NaN notitle\n",
      in_quotes(reason), style::kQuietInk);
}

// One plot in its box, between the commands of the head and of the legend.
class PlotScript {
 public:
  PlotScript(const Plot& plot, const Canvas& canvas, const PlotBox& box, std::size_t number)
      : plot_(plot), canvas_(canvas), box_(box), number_(number) {
    x_ends_ = ends_of(plot.x, range_of(plot.x, plot, [](const Series& series) {
                        return std::array{&series.x, &series.x_low, &series.x_high};
                      }));
    y_ends_ = ends_of(plot.y, range_of(plot.y, plot, [](const Series& series) {
                        return std::array{&series.y, &series.y_low, &series.y_low};
                      }));
    if (plot.has_equal_scales && std::isnan(plot.x.low)) make_scales_equal(x_ends_, y_ends_, box);
  }

  [[nodiscard]] std::string data() const {
    std::string blocks;
    for (std::size_t index = 0; index < plot_.series.size(); ++index)
      blocks += fmt::format("{} << EOD\n{}EOD\n", block_name(index), rows_of(plot_.series[index]));
    return blocks;
  }

  [[nodiscard]] std::string script() const {
    std::string text = fmt::format(
        "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
        "set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n",
        box_.left / canvas_.width, box_.right / canvas_.width, 1 - kBodyTop / canvas_.height,
        1 - box_.bottom / canvas_.height);
    if (is_empty(plot_)) return text + empty_script(plot_.when_empty);
    text += fmt::format(
        "set object rectangle from graph 0,0 to graph 1,1 behind fs solid 1 noborder fc rgb '{}'\n"
        "set xtics out font ',12' offset 0,0.3\nset ytics out font ',12' offset 0.5,0\n"
        "set grid {}tics back lt 1 lw 1 lc rgb '{}'\n",
        style::kPaper, grid_axis(), style::kHairline);
    text += axis_script('x', plot_.x, x_ends_) + axis_script('y', plot_.y, y_ends_);
    text += fmt::format("set label {} at {} left font ',12' tc rgb '{}'\n", in_quotes(plot_.y.label),
                        screen(canvas_, std::max(style::kMargin, box_.left - 48), kBodyTop - 32),
                        style::kQuietInk);
    text += fmt::format("set label {} at {} right font ',12' tc rgb '{}'\n", in_quotes(plot_.x.label),
                        screen(canvas_, box_.right, box_.bottom + 40), style::kQuietInk);
    for (const Span& span : plot_.spans)
      text += fmt::format(
          "set object rectangle from first {:.10g}, graph 0 to first {:.10g}, graph 1 behind fs solid 1 "
          "noborder fc rgb '{}'\n",
          span.from, span.to, style::kShade);
    for (const TopDot& dot : plot_.top_dots)
      text += fmt::format("set label '' at first {:.10g}, graph 1.035 point pt 7 ps 0.7 lc rgb '{}'\n", dot.x,
                          colour_of(dot.tone));
    for (const Mark& mark : plot_.marks) text += mark_script(mark);
    return text + bars() + texts() + plot_command();
  }

 private:
  [[nodiscard]] std::string block_name(std::size_t index) const {
    return fmt::format("$plot{}_{}", number_, index);
  }

  // Bars and several logarithmic scales are read along x, too.
  [[nodiscard]] std::string_view grid_axis() const {
    if (!plot_.y.categories.empty()) return "x";
    return plot_.x.is_logarithmic && plot_.y.is_logarithmic ? "xtics y" : "y";
  }

  [[nodiscard]] std::string rows_of(const Series& series) const {
    assert(series.y.size() == series.x.size());
    std::string rows;
    for (std::size_t row = 0; row < series.x.size(); ++row) {
      rows += fmt::format("{:.8g} {:.8g}", drawn(plot_.x, series.x[row]), drawn(plot_.y, series.y[row]));
      if (!series.y_low.empty()) rows += fmt::format(" {:.8g}", drawn(plot_.y, series.y_low[row]));
      if (!series.x_low.empty())
        rows += fmt::format(" {:.8g} {:.8g}", drawn(plot_.x, series.x_low[row]),
                            drawn(plot_.x, series.x_high[row]));
      rows += "\n";
    }
    return rows.empty() ? "NaN NaN NaN NaN\n" : rows;
  }

  static std::string label_script(std::string_view text, std::string_view place, Tone tone) {
    return fmt::format("set label {} at {} front font ',{}' tc rgb '{}'\n", in_quotes(text), place,
                       style::kLabelSize, colour_of(tone));
  }

  // From a point to the edge of its label, if that is not beside it.
  [[nodiscard]] std::string leader_script(const LabelPlacer::Point& point,
                                          const LabelPlacer::Point& edge) const {
    constexpr double kBeside = 10.0;
    if (std::hypot(edge.x - point.x, edge.y - point.y) <= kBeside) return {};
    return fmt::format("set arrow from {} to {} nohead front lw 0.75 lc rgb '{}'\n",
                       screen(canvas_, point.x, point.y), screen(canvas_, edge.x, edge.y), style::kQuietInk);
  }

  [[nodiscard]] static std::string mark_script(const Mark& mark) {
    const auto [from, to, at] =
        mark.is_vertical ? std::array{fmt::format("first {:.8g}, graph 0", mark.at),
                                      fmt::format("first {:.8g}, graph 1", mark.at),
                                      fmt::format("first {:.8g}, graph 1.035 center", mark.at)}
                         : std::array{fmt::format("graph 0, first {:.8g}", mark.at),
                                      fmt::format("graph 1, first {:.8g}", mark.at),
                                      fmt::format("graph 1, first {:.8g} right offset 0,0.5", mark.at)};
    std::string script = fmt::format("set arrow from {} to {} nohead front lw 1.5 dt (6,4) lc rgb '{}'\n",
                                     from, to, colour_of(mark.tone));
    if (!mark.text.empty()) script += label_script(mark.text, at, mark.tone);
    return script;
  }

  [[nodiscard]] std::string bars() const {
    std::string script;
    for (const Series& series : plot_.series)
      for (std::size_t row = 0; series.look.form == Form::bars && row < series.x.size(); ++row)
        script += fmt::format(
            "set object rectangle from first {:.8g}, first {:.6g} to first {:.8g}, first {:.6g} front fs "
            "solid 1 "
            "noborder fc rgb '{}'\n",
            x_ends_.low, series.y[row] - 0.32, std::clamp(series.x[row], x_ends_.low, x_ends_.high),
            series.y[row] + 0.32, colour_of(series.look.tone));
    return script;
  }

  // The part of its axis at which a value is, 0 at the low end.
  [[nodiscard]] static double part_of(double value, const Axis& axis, const AxisRange& ends) {
    const double shown = std::clamp(drawn(axis, value), ends.low, ends.high);
    const double part = axis.is_logarithmic ? std::log(shown / ends.low) / std::log(ends.high / ends.low)
                                            : (shown - ends.low) / (ends.high - ends.low);
    return axis.is_reversed ? 1.0 - part : part;
  }

  [[nodiscard]] LabelPlacer::Point on_canvas(double x, double y) const {
    const double up = part_of(y, plot_.y, y_ends_);
    const double down = plot_.y.categories.empty() ? 1.0 - up : up;
    return {box_.left + (box_.right - box_.left) * part_of(x, plot_.x, x_ends_),
            kBodyTop + (box_.bottom - kBodyTop) * down};
  }

  void avoid_series(LabelPlacer& placer, const Series& series) const {
    const bool is_line = series.look.form == Form::line || series.look.form == Form::line_and_points;
    for (std::size_t row = 0; row < series.x.size() && series.look.form != Form::band; ++row) {
      if (std::isnan(series.x[row]) || std::isnan(series.y[row])) continue;
      const LabelPlacer::Point at = on_canvas(series.x[row], series.y[row]);
      if (is_line && row > 0 && !std::isnan(series.x[row - 1]) && !std::isnan(series.y[row - 1]))
        placer.avoid(on_canvas(series.x[row - 1], series.y[row - 1]), at);
      const double half = 3.5 * series.look.marker_size;
      placer.avoid({at.x - half, at.y}, {at.x + half, at.y});
      if (series.look.form == Form::bars) placer.avoid(on_canvas(x_ends_.low, series.y[row]), at);
      if (!series.x_low.empty())
        placer.avoid(on_canvas(series.x_low[row], series.y[row]),
                     on_canvas(series.x_high[row], series.y[row]));
    }
  }

  [[nodiscard]] std::string texts() const {
    LabelPlacer placer({box_.left, kBodyTop, box_.right, box_.bottom});
    for (const Series& series : plot_.series) avoid_series(placer, series);
    for (const Mark& mark : plot_.marks)
      placer.avoid(
          on_canvas(mark.is_vertical ? mark.at : x_ends_.low, mark.is_vertical ? y_ends_.low : mark.at),
          on_canvas(mark.is_vertical ? mark.at : x_ends_.high, mark.is_vertical ? y_ends_.high : mark.at));
    std::string script;
    for (const PointText& text : plot_.texts) {
      const LabelPlacer::Point point = on_canvas(text.x, text.y);
      if (!plot_.y.categories.empty()) {  // In its row, whatever is beside it.
        script += label_script(text.text, screen(canvas_, point.x + 8, point.y) + " left", text.tone);
        continue;
      }
      const LabelPlacer::Point at = placer.place(text.text, LabelPlacer::centres_around(point, text.text));
      const LabelPlacer::Point edge = LabelPlacer::nearest_of(text.text, at, point);
      placer.avoid(point, edge);
      script += label_script(text.text, screen(canvas_, at.x, at.y) + " center", text.tone) +
                leader_script(point, edge);
    }
    return script;
  }

  [[nodiscard]] static std::string form_script(const Look& look) {
    switch (look.form) {
      case Form::band:
        return "with filledcurves fs solid 1";
      case Form::points:
        return fmt::format("with points {} lw 1.5", marker_of(look));
      case Form::line_and_points:
        return fmt::format("with linespoints {} {}", marker_of(look), stroke_of(look));
      case Form::line:
      case Form::bars:
        break;
    }
    return fmt::format("with lines {}", stroke_of(look));
  }

  [[nodiscard]] std::string plot_command() const {
    std::string command;
    const auto add = [&](const std::string& part) { command += (command.empty() ? "plot " : ", ") + part; };
    for (std::size_t index = 0; index < plot_.series.size(); ++index) {
      const Series& series = plot_.series[index];
      if (series.look.form == Form::bars) continue;
      const std::string_view colour = colour_of(series.look.tone);
      if (!series.x_low.empty())
        add(fmt::format("{} using 1:2:{}:{} notitle with xerrorbars pt 0 lw 1 lc rgb '{}'", block_name(index),
                        series.y_low.empty() ? 3 : 4, series.y_low.empty() ? 4 : 5, colour));
      add(fmt::format("{} using {} title {} {} lc rgb '{}'", block_name(index),
                      series.look.form == Form::band ? "1:3:2" : "1:2", in_quotes(series.name),
                      form_script(series.look), colour));
    }
    return (command.empty() ? "plot NaN notitle" : command) + "\n";
  }

  const Plot& plot_;
  const Canvas& canvas_;
  PlotBox box_;
  std::size_t number_;
  AxisRange x_ends_, y_ends_;
};

double left_of(const Plot& plot) {
  std::size_t letters = 0;
  for (const std::string& category : plot.y.categories) letters = std::max(letters, letters_of(category));
  return std::max(kLeft, style::kMargin + kLetter_px * static_cast<double>(letters));
}

}  // namespace

std::string power_of_ten(int exponent) {
  constexpr std::array<std::string_view, 10> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kRaised[static_cast<std::size_t>(digit - '0')];
  return text;
}

Canvas body_size(const std::vector<Plot>& plots) {
  if (plots.size() > 1) return {kWidthOfSeveral, kHeightOfSeveral + kBelow};
  if (plots.empty()) return {kWidth, kHeight + kBelow};
  const Plot& plot = plots.front();
  double height = kHeight;
  if (!plot.y.categories.empty()) height = kCategory * static_cast<double>(plot.y.categories.size());
  if (plot.has_equal_scales && !std::isnan(plot.x.low))
    height = (kWidth - kLeft - kRight) * (plot.y.high - plot.y.low) / (plot.x.high - plot.x.low);
  return {kWidth, height + kBelow};
}

std::string body_script(const std::vector<Plot>& plots, const Canvas& canvas) {
  const double bottom = kBodyTop + body_size(plots).height - kBelow;
  if (plots.empty()) return empty_script("nothing to show");
  std::string data, script = plots.size() > 1 ? "set multiplot\n" : "";
  const double shares = std::accumulate(plots.begin(), plots.end(), 0.0,
                                        [](double sum, const Plot& plot) { return sum + plot.share; });
  double start = 0.0;
  for (std::size_t index = 0; index < plots.size(); ++index) {
    const double width = canvas.width * plots[index].share / shares;
    const PlotScript plot(plots[index], canvas,
                          {start + left_of(plots[index]), start + width - kRight, bottom}, index);
    start += width;
    data += plot.data();
    script += plot.script();
    // What is drawn with one plot is not drawn again with the next.
    if (index + 1 < plots.size())
      script += "unset label\nunset object\nunset arrow\nunset logscale\nset format\n";
  }
  return data + script + (plots.size() > 1 ? "unset multiplot\n" : "");
}

}  // namespace hyrax
