// A picture of numbers as data: series on axes, a grid of coloured cells, or a list of texts. Nothing here
// draws; tools/report draws any figure and knows no study.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hyrax {

/// Colours by their part in a picture: text and lines (ink .. hairline), hues that colour-blind readers can
/// distinguish, pale fills behind text or series (good, notable, bad, shade, none).
enum class Tone : std::uint8_t {
  ink,
  quiet,
  faint,
  hairline,
  vermilion,
  orange,
  blue,
  green,
  purple,
  sky_blue,
  lavender,
  good,
  notable,
  bad,
  shade,
  none,
  ramp_1,  ///< A ramp of six for what has an order.
  ramp_2,
  ramp_3,
  ramp_4,
  ramp_5,
  ramp_6
};

/// Of ordered series, the `place`-th of `count`. REQUIRES: place < count.
[[nodiscard]] constexpr Tone ramp_tone(std::size_t place, std::size_t count) {
  const std::size_t step = count > 1 ? place * 5 / (count - 1) : 0;
  return static_cast<Tone>(static_cast<std::size_t>(Tone::ramp_1) + step);
}

/// Dots, or triangles that point to a wall.
enum class Marker : std::uint8_t { dot, ring, square, to_left, to_right, to_top, to_ground };

/// Of walls in every picture: left, right, top, ground. The page has the same in painter.js.
inline constexpr std::array<Marker, 4> kWallMarkers = {Marker::to_left, Marker::to_right, Marker::to_top,
                                                       Marker::to_ground};
inline constexpr std::array<Tone, 4> kWallTones = {Tone::sky_blue, Tone::vermilion, Tone::purple,
                                                   Tone::orange};

inline constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

struct Tick {
  double at = 0.0;
  std::string text = {};
};

struct Axis {
  std::string label = {};  ///< Quantity and unit.
  bool is_logarithmic = false;
  bool is_reversed = false;
  double low = kNotGiven;  ///< Ends of the axis; not given: from the data.
  double high = kNotGiven;
  std::vector<Tick> ticks = {};  ///< Empty: chosen by whoever draws; powers of ten if logarithmic.
  int decimals = -1;             ///< Of the numbers at its ticks; -1: as many as each needs.
  std::vector<std::string> categories =
      {};  ///< If there are any: names of 0, 1, 2, ..., from the top of a y axis.
  /// Of a logarithmic axis: data at most this large are drawn here, with this text at the tick.
  double zero_at = kNotGiven;
  std::string zero_text = "0";
  /// Of a logarithmic y axis: data up to this are drawn in a strip of their own below the rest, which would
  /// leave most of the decades between them empty.
  double strip_below = kNotGiven;
  std::string strip_name = {};
};

enum class Form : std::uint8_t {
  line,
  points,
  line_and_points,
  band,  ///< The area between y_low and y.
  bars   ///< From the low end of the x axis to x, one a category.
};
enum class Dash : std::uint8_t { solid, short_dashes, long_dashes, dots };

/// How a series looks.
struct Look {
  Form form = Form::line;
  Tone tone = Tone::ink;
  double width_px = 2.5;
  Dash dash = Dash::solid;
  Marker marker = Marker::dot;
  double marker_size = 0.6;  ///< 1: about 7 px.
};

/// A NaN in y is a gap in the line.
struct Series {
  std::string name = {};  ///< For readers: the title of its part of the picture.
  Look look = {};
  std::vector<double> x = {};
  std::vector<double> y = {};      ///< As many as x.
  std::vector<double> y_low = {};  ///< Of a band: as many as x.
  std::vector<double> x_low = {};  ///< With x_high: bars of spread through the points; as many as x, or none.
  std::vector<double> x_high = {};
  std::vector<std::string> point_names = {};  ///< "60 Hz"; as many as x, or none.
};

/// A dashed line across the plot.
struct Mark {
  bool is_vertical = true;
  double at = 0.0;
  std::string text = {};  ///< At its upper or right end; may be empty.
  Tone tone = Tone::ink;
};

/// Text beside a point, off the series, the marks and other texts where there is room.
struct PointText {
  double x = 0.0;
  double y = 0.0;
  std::string text = {};
  Tone tone = Tone::quiet;
  bool is_optional = false;  ///< Left out where it would cover another text.
};

/// A shaded part of the x axis, behind the series.
struct Span {
  double from = 0.0;
  double to = 0.0;
};

/// A sign above the plot.
struct TopDot {
  double x = 0.0;
  Tone tone = Tone::ink;
  Marker marker = Marker::dot;
};

struct Plot {
  Axis x = {};
  Axis y = {};
  std::vector<Series> series = {};  ///< The later over the earlier.
  std::vector<Mark> marks = {};
  std::vector<PointText> texts = {};
  std::vector<Span> spans = {};
  std::vector<TopDot> top_dots = {};
  std::string when_empty = "nothing to show";  ///< Instead of a plot whose series have no points.
  /// One px of x is as long as one px of y; an axis is widened for that unless its ends are given.
  bool has_equal_scales = false;
};

/// A part of a field of a grid, from `left` to `right` (0 .. 1 of its width).
struct Cell {
  std::size_t row = 0;
  std::size_t column = 0;
  Tone tone = Tone::none;
  std::string text = {};
  double left = 0.0;
  double right = 1.0;
};

struct Grid {
  std::vector<std::string> rows = {};
  std::vector<std::pair<std::string, Tone>> columns = {};  ///< Names above, slanted.
  std::vector<Cell> cells = {};
};

struct LegendEntry {
  std::string text = {};
  Look look = {};
};

struct Figure {
  std::string suffix = {};  ///< Of its file's name: empty, or begins with "-".
  std::string title = {};
  std::string subtitle = {};
  std::string note = {};  ///< At the title's right: what else a reader would take wrongly; may be empty.
  Tone note_tone = Tone::vermilion;
  std::variant<std::vector<Plot>, Grid> body =
      {};  ///< Plots are side by side, those of equal scales in twos; of one x, stacked.
  std::vector<LegendEntry> legend = {};
  std::vector<std::string> remarks = {};  ///< Sentences below.
  std::size_t row_count = 0;  ///< Lines of as many points have one a row: a page has a slider over them.
};

}  // namespace hyrax
