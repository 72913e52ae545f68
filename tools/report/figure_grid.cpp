#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "tools/report/figure_body.h"

namespace hyrax {
namespace {

constexpr double kRow = 21;  // All in px of the SVG.
constexpr double kColumnMin = 24;
constexpr double kColumnMax = 50;
constexpr double kGridWidth = 960;
constexpr double kSmallLetter_px = 6.6;  // At 12 px.
constexpr double kSlant = 0.8;           // Of a slanted name's length, what is upright.
constexpr double kListRow = 38;
constexpr double kListHead = 26;
constexpr double kFill = 9;  // Half the height of the colour behind a listing's text.

constexpr std::string_view kEmptyAxes =
    "unset xtics\nunset ytics\nset lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
    "set xrange [0:1]\nset yrange [0:1]\n";

double longest(const std::vector<std::string>& texts) {
  std::size_t letters = 0;
  for (const std::string& text : texts) letters = std::max(letters, letters_of(text));
  return kSmallLetter_px * static_cast<double>(letters);
}

// The place of a grid's fields on the canvas.
struct GridPlaces {
  double left = 0.0;
  double top = 0.0;
  double column = 0.0;  // Width of one.
  double width = 0.0;   // Of the canvas.

  explicit GridPlaces(const Grid& grid) {
    std::vector<std::string> names;
    for (const auto& [name, tone] : grid.columns) names.push_back(name);
    left = style::kMargin + longest(grid.rows) + 10;
    top = kBodyTop - 40 + kSlant * longest(names);
    const double count = static_cast<double>(std::max<std::size_t>(names.size(), 1));
    column = std::clamp((kGridWidth - left - 2 * style::kMargin) / count, kColumnMin, kColumnMax);
    width = std::max(kGridWidth / 2, left + column * count + 2 * style::kMargin);
  }
};

std::string box(const Canvas& canvas, double x, double y, double width, double height, Tone tone) {
  return fmt::format("set object rectangle from {} to {} fs solid 1 noborder fc rgb '{}'\n",
                     screen(canvas, x, y), screen(canvas, x + width, y + height), colour_of(tone));
}

std::string shortened(const std::string& text, std::size_t letters_max) {
  if (letters_max == 0 || text.size() <= letters_max) return text;
  return text.substr(0, text.rfind(' ', letters_max - 2)) + " …";
}

}  // namespace

Canvas body_size(const Grid& grid) {
  const GridPlaces places(grid);
  return {places.width, places.top - kBodyTop + kRow * static_cast<double>(grid.rows.size()) + 16};
}

std::string body_script(const Grid& grid, const Canvas& canvas) {
  const GridPlaces places(grid);
  std::string script(kEmptyAxes);
  const auto x_of = [&](std::size_t column) {
    return places.left + places.column * static_cast<double>(column);
  };
  const auto y_of = [&](std::size_t row) { return places.top + kRow * static_cast<double>(row); };
  for (std::size_t column = 0; column < grid.columns.size(); ++column)
    script += fmt::format("set label {} at {} left rotate by 50 font ',12' tc rgb '{}'\n",
                          in_quotes(grid.columns[column].first),
                          screen(canvas, x_of(column) + places.column / 2 - 4, places.top - 10),
                          colour_of(grid.columns[column].second));
  for (std::size_t row = 0; row < grid.rows.size(); ++row)
    script += fmt::format("set label {} at {} right font ',12' tc rgb '{}'\n", in_quotes(grid.rows[row]),
                          screen(canvas, places.left - 10, y_of(row) + kRow / 2), style::kInk);
  for (const Cell& cell : grid.cells) {
    const double x = x_of(cell.column) + 1 + cell.left * (places.column - 2);
    const double width = (cell.right - cell.left) * (places.column - 2);
    script += box(canvas, x, y_of(cell.row) + 1, width, kRow - 2, cell.tone);
    if (!cell.text.empty())
      script += fmt::format("set label {} at {} center front font ',12' tc rgb '{}'\n", in_quotes(cell.text),
                            screen(canvas, x + width / 2, y_of(cell.row) + kRow / 2), style::kInk);
  }
  return script + "plot NaN notitle\n";
}

Canvas body_size(const Listing& listing) {
  double width = 2 * style::kMargin;
  for (const ListColumn& column : listing.columns) width += column.width_px;
  return {width, kListHead + kListRow * static_cast<double>(listing.rows.size()) - 30};
}

std::string body_script(const Listing& listing, const Canvas& canvas) {
  std::string script(kEmptyAxes);
  const auto add = [&](const std::string& text, double x, double y, std::string_view side, int size,
                       std::string_view colour) {
    script += fmt::format("set label {} at {} {} front font ',{}' tc rgb '{}'\n", in_quotes(text),
                          screen(canvas, x, y), side, size, colour);
  };
  constexpr double kTop = kBodyTop - 30;
  double left = style::kMargin;
  for (std::size_t index = 0; index < listing.columns.size(); ++index) {
    const ListColumn& column = listing.columns[index];
    const double end = column.is_right ? left + column.width_px : left;
    const std::string_view side = column.is_right ? "right" : "left";
    if (!column.title.empty()) add(column.title, end, kTop, side, 12, style::kQuietInk);
    for (std::size_t row = 0; row < listing.rows.size(); ++row) {
      assert(listing.rows[row].size() == listing.columns.size());
      const ListField& field = listing.rows[row][index];
      const double y = kTop + kListHead + kListRow * static_cast<double>(row);
      const std::string text = shortened(field.text, column.letters_max);
      if (field.fill == Tone::none) {
        add(text, end, y, side, index == 0 ? 12 : 13, index == 0 ? style::kQuietInk : style::kInk);
      } else {
        constexpr double kSpace = 8;
        script += box(canvas, left, y - kFill, column.width_px - kSpace, 2 * kFill, field.fill);
        add(text, left + (column.width_px - kSpace) / 2, y, "center", 12, style::kInk);
      }
      // Smaller letters: a quarter more of them fit.
      if (!field.detail.empty())
        add(shortened(field.detail, column.letters_max + column.letters_max / 4), end, y + 16, side, 10,
            style::kQuietInk);
    }
    left += column.width_px;
  }
  return script + "plot NaN notitle\n";
}

}  // namespace hyrax
