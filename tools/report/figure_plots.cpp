#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>

#include "sim/result/number_text.h"
#include "tools/report/figure_body.h"
#include "tools/report/label_placer.h"
#include "tools/report/plot_scale.h"

namespace hyrax {
namespace {

constexpr double kWidth = 960.0;  // All in px of the SVG.
constexpr double kWidthOfSeveral = 1180.0;
constexpr double kHeight = 300.0;
constexpr double kHeightOfSeveral = 420.0;
constexpr double kPlotMin = 360.0;  // Of plots side by side.
constexpr double kCategory = 26.0;
constexpr double kCategoryWithText = 60.0;  // Its name above, texts at its points below.
constexpr double kRight = 26.0;
constexpr double kBetween = 12.0;    // Plots and those below them.
constexpr double kLabelLine = 19.0;  // Of the y axis's label, and of each line of texts at marks.
constexpr double kBelow = 50.0;      // Ticks and label of the x axis.
constexpr double kTickSize = 12.0;
constexpr double kTextLine = 15.0;
constexpr double kApart = 85.0;    // Between ticks of x,
constexpr double kApartUp = 40.0;  // and of y.

bool is_empty(const Plot& plot) {
  return std::all_of(plot.series.begin(), plot.series.end(),
                     [](const Series& series) { return series.x.empty(); });
}

// All values along one axis: its own and those that spread along it.
std::vector<double> values_of(const Plot& plot,
                              std::initializer_list<std::vector<double> Series::*> columns) {
  std::vector<double> values;
  for (const Series& series : plot.series)
    for (const auto column : columns)
      values.insert(values.end(), (series.*column).begin(), (series.*column).end());
  return values;
}

// One plot in its place on the sheet.
class PlotDrawing {
 public:
  /// @param height of a plot whose axes do not give it.
  /// @param axis_left the y axis is there or further right, where its ticks need more room.
  PlotDrawing(Svg& svg, const Plot& plot, double left, double right, double top, double height,
              double axis_left)
      : svg_(svg),
        plot_(plot),
        left_(left),
        axis_left_(axis_left),
        x_(plot.x, values_of(plot, {&Series::x, &Series::x_low, &Series::x_high})),
        y_(plot.y, values_of(plot, {&Series::y, &Series::y_low})) {
    if (!plot.y.categories.empty()) {
      box_.right = right;
      place_x();
      has_names_above_ = !has_room_beside();
    }
    y_label_ = lines_of(plot.y.label, right - left, kTickSize);
    box_ = {left, top + kLabelLine + text_lines(y_label_) + marks_height() + 4, right, 0.0};
    box_.bottom = box_.top + height_of(right - left, height);
    const bool is_downwards = !plot.y.categories.empty();
    y_.place(is_downwards ? box_.top : box_.bottom, is_downwards ? box_.bottom : box_.top, kApartUp);
    place_x();
    if (plot.has_equal_scales) {  // An axis that is widened has other ticks.
      PlotScale::make_equal(x_, y_);
      place_x();
      PlotScale::make_equal(x_, y_);
    }
    x_label_ = lines_of(plot.x.label, box_.right - left, kTickSize);
  }

  [[nodiscard]] double axis_left() const { return box_.left; }
  /// Of the plot with what is below its axis.
  [[nodiscard]] double bottom() const { return box_.bottom + kBelow - 8 + text_lines(x_label_); }

  void draw() {
    if (is_empty(plot_)) {
      draw_lines(lines_of(plot_.when_empty, box_.width(), kTickSize), box_.centre(), Side::middle);
      return;
    }
    draw_axes();
    svg_.begin_clip({box_.left - 6, box_.top - 6, box_.right + 6, box_.bottom + 6},
                    " data-x=\"" + escaped(x_.text()) + "\" data-y=\"" + escaped(y_.text()) + "\"");
    for (const Series& series : plot_.series) draw_series(series);
    svg_.end_clip();
    draw_marks();
    draw_texts();
  }

 private:
  // Right of the texts at the ticks of y.
  void place_x() {
    double ticks_width = 0.0;
    for (const Tick& tick : y_.ticks()) ticks_width = std::max(ticks_width, text_width(tick.text, kTickSize));
    box_.left = std::max(axis_left_, left_ + 10 + (has_names_above_ ? 0.0 : ticks_width));
    x_.place(box_.left, box_.right, kApart);
  }

  // For names at the left of their points, and texts at the right.
  [[nodiscard]] bool has_room_beside() const {
    constexpr double kNamesMax = 0.42;  // Of the width.
    return box_.left - left_ - 10 <= kNamesMax * (box_.right - left_) &&
           std::ranges::all_of(plot_.texts, [&](const PointText& text) {
             return text_beside(text) <= text_end() - text_width(text.text, LabelPlacer::kSize);
           });
  }
  // Where the text of a point begins, and where it may end.
  [[nodiscard]] double text_beside(const PointText& text) const { return x_.clamped(text.x) + 8; }
  [[nodiscard]] double text_end() const { return box_.right + kRight - 4; }

  [[nodiscard]] SvgPoint at(double x, double y) const { return {x_.at(x), y_.at(y)}; }
  [[nodiscard]] std::vector<SvgPoint> points_of(const Series& series) const {
    std::vector<SvgPoint> points;
    for (std::size_t row = 0; row < series.x.size(); ++row)
      points.push_back(at(series.x[row], series.y[row]));
    return points;
  }

  [[nodiscard]] double height_of(double width, double height) const {
    if (!plot_.y.categories.empty())
      return (has_names_above_ ? kCategoryWithText : kCategory) *
             static_cast<double>(plot_.y.categories.size());
    const double ratio = (plot_.y.high - plot_.y.low) / (plot_.x.high - plot_.x.low);
    return plot_.has_equal_scales && std::isfinite(ratio) ? (width - kSheetMargin) * ratio : height;
  }

  // Texts at vertical marks and dots are above the plot.
  [[nodiscard]] double marks_height() const {
    const bool has_texts = std::any_of(plot_.marks.begin(), plot_.marks.end(), [](const Mark& mark) {
      return mark.is_vertical && !mark.text.empty();
    });
    return has_texts || !plot_.top_dots.empty() ? kLabelLine : 0.0;
  }

  void draw_axes() {
    const Pen rule{colour_named("rule"), 1.0};
    for (const Span& span : plot_.spans)
      svg_.box({x_.clamped(span.from), box_.top, x_.clamped(span.to), box_.bottom}, colour_of(Tone::shade));
    if (const auto strip = y_.end_of_strip()) {
      svg_.box({box_.left, *strip, box_.right, box_.bottom}, colour_of(Tone::shade), 0.0, 0.6);
      svg_.text({box_.right - 6, *strip + 10}, plot_.y.strip_name,
                {.size = LabelPlacer::kSize, .side = Side::right});
    }
    const bool has_columns = !plot_.y.categories.empty() || plot_.has_equal_scales ||
                             (plot_.x.is_logarithmic && plot_.y.is_logarithmic);
    double end = -HUGE_VAL;
    for (const Tick& tick : x_.ticks()) {
      const double x = x_.at(tick.at), half = text_width(tick.text, kTickSize) / 2;
      if (has_columns) svg_.line({{x, box_.top}, {x, box_.bottom}}, rule);
      const double middle = std::clamp(x, left_ + half, box_.right + kRight - 4 - half);  // Not cut.
      if (middle - half < end + 6) continue;
      end = middle + half;
      svg_.text({middle, box_.bottom + 16}, tick.text, {.size = kTickSize, .side = Side::middle});
    }
    for (const Tick& tick : y_.ticks()) {
      const double y = y_.at(tick.at);
      if (plot_.y.categories.empty()) svg_.line({{box_.left, y}, {box_.right, y}}, rule);
      if (has_names_above_)
        svg_.text({left_, y - 18}, tick.text, {.size = kTickSize, .has_edge = true});
      else
        svg_.text({box_.left - 8, y}, tick.text, {.size = kTickSize, .side = Side::right});
    }
    draw_lines(y_label_, {left_, box_.top - marks_height() - 14 - text_lines(y_label_)}, Side::left);
    draw_lines(x_label_, {box_.right, box_.bottom + 36}, Side::right);
  }

  // The height of all but the first.
  static double text_lines(const std::vector<std::string>& lines) {
    return lines.empty() ? 0.0 : kTextLine * static_cast<double>(lines.size() - 1);
  }
  void draw_lines(const std::vector<std::string>& lines, SvgPoint at, Side side) {
    for (const std::string& line : lines) {
      svg_.text(at, line, {.size = kTickSize, .side = side});
      at.y += kTextLine;
    }
  }

  void draw_series(const Series& series) {
    assert(series.y.size() == series.x.size());
    svg_.begin(series.name);
    const std::string& colour = colour_of(series.look.tone);
    const Look& look = series.look;
    std::vector<SvgPoint> points = points_of(series);
    for (std::size_t row = 0; row < series.x_low.size(); ++row)
      svg_.line({at(series.x_low[row], series.y[row]), at(series.x_high[row], series.y[row])},
                {colour, 1.25});
    if (look.form == Form::band) {
      for (std::size_t row = series.x.size(); row-- > 0;)
        points.push_back(at(series.x[row], series.y_low[row]));
      svg_.area(points, colour, opacity_of(look));
    }
    if (look.form == Form::bars)
      for (const SvgPoint& end : points)
        svg_.box({box_.left, end.y - kCategory * 0.34, std::max(end.x, box_.left), end.y + kCategory * 0.34},
                 colour, 2.0);
    if (look.form == Form::line || look.form == Form::line_and_points)
      svg_.line(points, {colour, look.width_px, look.dash});
    if (look.form == Form::points || look.form == Form::line_and_points)
      for (std::size_t row = 0; row < points.size(); ++row)
        svg_.sign(points[row], look.marker, look.marker_size, colour, tip(series, row));
    svg_.end();
  }

  // What a point is: its name, and its place in the words of the axes.
  [[nodiscard]] std::string tip(const Series& series, std::size_t row) const {
    const auto part = [](const Axis& axis, double value) {
      if (value >= 0.0 && value < static_cast<double>(axis.categories.size()))
        return "; " + axis.categories[static_cast<std::size_t>(value)];
      return "; " + (axis.label.empty() ? "" : axis.label + ": ") + rounded(value, 5);
    };
    return series.name + (series.point_names.empty() ? "" : ", " + series.point_names[row]) +
           part(plot_.x, series.x[row]) + part(plot_.y, series.y[row]);
  }

  void draw_marks() {
    for (const TopDot& dot : plot_.top_dots)
      svg_.sign({x_.at(dot.x), box_.top - 9}, dot.marker, 0.9, colour_of(dot.tone));
    double end = -HUGE_VAL;
    std::vector<Mark> marks = plot_.marks;
    std::ranges::stable_sort(marks, {},
                             [&](const Mark& mark) { return mark.is_vertical ? x_.at(mark.at) : 0.0; });
    for (const Mark& mark : marks) {
      const Pen pen{colour_of(mark.tone), 1.25, Dash::short_dashes};
      if (!mark.is_vertical) {
        const double y = y_.at(mark.at);
        if (!(y >= box_.top - 1 && y <= box_.bottom + 1)) continue;
        svg_.line({{box_.left, y}, {box_.right, y}}, pen);
        svg_.text({box_.right, y - 9}, mark.text,
                  {.size = LabelPlacer::kSize, .tone = mark.tone, .side = Side::right, .has_edge = true});
        continue;
      }
      const double x = x_.at(mark.at), width = text_width(mark.text, LabelPlacer::kSize);
      if (!(x >= box_.left - 1 && x <= box_.right + 1)) continue;
      svg_.line({{x, box_.top}, {x, box_.bottom}}, pen);
      // Beside the one before, where both would overlap.
      const double middle = std::clamp(std::max(x, end + 8 + width / 2), kSheetMargin + width / 2,
                                       box_.right + kRight - 8 - width / 2);
      if (middle - width / 2 < end) continue;
      if (!mark.text.empty()) end = middle + width / 2;
      svg_.text({middle, box_.top - 10}, mark.text,
                {.size = LabelPlacer::kSize, .tone = mark.tone, .side = Side::middle});
    }
  }

  void avoid_series(LabelPlacer& placer, const Series& series) const {
    const std::vector<SvgPoint> points = points_of(series);
    if (series.look.form == Form::line || series.look.form == Form::line_and_points)
      placer.avoid_line(points);
    for (std::size_t row = 0; row < points.size() && series.look.form != Form::band; ++row) {
      const auto [x, y] = points[row];
      const double half = 3.5 * series.look.marker_size;
      placer.avoid({x - half, y}, {x + half, y});
      if (!series.x_low.empty())
        placer.avoid(at(series.x_low[row], series.y[row]), at(series.x_high[row], series.y[row]));
    }
  }

  void draw_texts() {
    LabelPlacer placer({box_.left + 2, box_.top + 2, text_end(), box_.bottom - 2});
    for (const Series& series : plot_.series) avoid_series(placer, series);
    for (const Mark& mark : plot_.marks)
      if (mark.is_vertical)
        placer.avoid({x_.at(mark.at), box_.top}, {x_.at(mark.at), box_.bottom});
      else
        placer.avoid({box_.left, y_.at(mark.at)}, {box_.right, y_.at(mark.at)});
    if (const auto strip = y_.end_of_strip()) {
      const double half = LabelPlacer::width(plot_.y.strip_name) / 2;
      static_cast<void>(placer.place(plot_.y.strip_name, {{box_.right - 6 - half, *strip + 10}}));
    }
    for (const PointText& text : plot_.texts) {
      const SvgPoint point{x_.clamped(text.x), y_.clamped(text.y)};
      if (plot_.y.categories.empty())
        placer.draw_beside(svg_, point, text.text, text.tone, text.is_optional);
      else  // In its row, whatever is beside it; where names are above, below.
        svg_.text({std::min(text_beside(text), text_end() - text_width(text.text, LabelPlacer::kSize)),
                   point.y + (has_names_above_ ? 18 : 0)},
                  text.text, {.size = LabelPlacer::kSize, .tone = text.tone, .has_edge = true});
    }
  }

  Svg& svg_;
  const Plot& plot_;
  double left_;  // Of the place.
  double axis_left_;
  PlotScale x_, y_;
  Box box_;
  bool has_names_above_ = false;
  std::vector<std::string> x_label_, y_label_;  // Their lines.
};

// Takes the names of curves out of a plot that is too narrow for them, with the room beside the curves; an
// area is left to the figure's legend.
std::vector<LegendEntry> take_names(Plot& plot) {
  std::vector<LegendEntry> names;
  std::erase_if(plot.texts, [&](const PointText& text) {
    const Series* its = nullptr;
    for (const Series& series : plot.series)
      if (series.look.form != Form::points && !series.name.empty() && text.text.starts_with(series.name) &&
          (its == nullptr || series.name.size() > its->name.size()))
        its = &series;
    if (its != nullptr && its->look.form != Form::band) names.push_back({text.text, its->look});
    return its != nullptr;
  });
  if (!names.empty() && !plot.has_equal_scales) plot.x.high = kNotGiven;
  return names;
}

// One below the other: the same x axis, with the same ends.
bool are_stacked(const std::vector<Plot>& plots) {
  return plots.size() > 1 && std::ranges::all_of(plots, [&](const Plot& plot) {
           const Axis &x = plot.x, &first = plots.front().x;
           return x.label == first.label && x.low == first.low && x.high == first.high;
         });
}

}  // namespace

double sheet_width(const std::vector<Plot>& plots) {
  return plots.size() > 1 && !are_stacked(plots) ? kWidthOfSeveral : kWidth;
}

double draw_body(Svg& svg, const std::vector<Plot>& plots, double width, double top) {
  if (plots.empty()) {
    svg.text({width / 2, top + kHeight / 2}, "nothing to show", {.side = Side::middle});
    return top + kHeight;
  }
  const bool is_stack = are_stacked(plots);
  // As many side by side as are wide enough.
  const std::size_t most = is_stack ? 1 : plots.front().has_equal_scales ? 2 : plots.size();
  const std::size_t beside =
      std::clamp(static_cast<std::size_t>(width / kPlotMin), std::size_t{1}, std::min(most, plots.size()));
  double end = top, axis_left = 0.0;
  for (const Plot& plot : plots)
    if (is_stack)
      axis_left = PlotDrawing(svg, plot, kSheetMargin, width - kRight, top, kHeight, axis_left).axis_left();
  for (std::size_t index = 0; index < plots.size(); ++index) {
    const std::size_t column = index % beside;
    if (column == 0 && index > 0) top = end + kBetween;
    const bool is_alone = beside == 1 || (column == 0 && index > 0 && index + 1 == plots.size());
    const double part = is_alone ? width : width / static_cast<double>(beside);
    const double height = is_alone ? kHeight : kHeightOfSeveral, start = static_cast<double>(column) * part;
    Plot plot = plots[index];
    const bool is_narrow = part < kPlotMin && plot.y.categories.empty();
    const std::vector<LegendEntry> names = is_narrow ? take_names(plot) : std::vector<LegendEntry>();
    PlotDrawing drawing(svg, plot, start + kSheetMargin, start + part - kRight, top, height, axis_left);
    drawing.draw();
    end = std::max(end, draw_legend(svg, names, width, drawing.bottom()));
  }
  return end;
}

}  // namespace hyrax
