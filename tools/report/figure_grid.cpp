#include <algorithm>

#include "tools/report/figure_body.h"

namespace hyrax {
namespace {

constexpr double kRow = 21.0;  // All in px of the SVG.
constexpr double kGridText = 12.0;
constexpr double kColumnMin = 24.0;
constexpr double kColumnMax = 50.0;
constexpr double kGridWidth = 960.0;
constexpr double kTurned_deg = 50.0;
constexpr double kRise = 0.77, kRun = 0.65;  // Their sine and cosine.
constexpr double kNameAbove = 16.0;          // A row's, where there is no room at its left.

double widest(const std::vector<std::string>& texts) {
  double width = 0.0;
  for (const std::string& text : texts) width = std::max(width, text_width(text, kGridText));
  return width;
}

// The place of a grid's fields on the sheet. On a narrow one a row's name is above its fields, and those of
// columns are upright.
struct GridPlaces {
  double left = 0.0;
  double head = 0.0;    // Height of the names above.
  double column = 0.0;  // Width of one.
  double row = kRow;    // Height of one.
  double right = 0.0;   // Of all, slanted names included.
  bool is_narrow = false;

  GridPlaces(const Grid& grid, double width) {
    std::vector<std::string> names;
    for (const auto& [name, tone] : grid.columns) names.push_back(name);
    left = kSheetMargin + widest(grid.rows) + 10;
    head = kRise * widest(names) + 20;
    const double count = static_cast<double>(std::max<std::size_t>(names.size(), 1));
    column = (width - left - 2 * kSheetMargin) / count;
    if (is_narrow = width < kGridWidth && column < kColumnMin; is_narrow) {
      left = kSheetMargin;
      head = widest(names) + 16;
      row = kRow + kNameAbove;
      column = std::min((width - 2 * kSheetMargin) / count, kColumnMax);
      return;
    }
    column = std::clamp(column, kColumnMin, kColumnMax);
    for (std::size_t index = 0; index < names.size(); ++index)
      right = std::max(right, left + column * (static_cast<double>(index) + 0.5) +
                                  kRun * text_width(names[index], kGridText));
    right = std::max(right, left + column * count);
  }
};

}  // namespace

double sheet_width(const Grid& grid) {
  return std::max(kGridWidth / 2, GridPlaces(grid, kGridWidth).right + kSheetMargin);
}

double draw_body(Svg& svg, const Grid& grid, double width, double start) {
  const GridPlaces places(grid, width);
  const double top = start + places.head;
  const auto x_of = [&](std::size_t column) {
    return places.left + places.column * static_cast<double>(column);
  };
  const auto y_of = [&](std::size_t row) {  // Of its fields.
    return top + places.row * static_cast<double>(row + 1) - kRow;
  };
  for (std::size_t column = 0; column < grid.columns.size(); ++column)
    svg.text({x_of(column) + places.column / 2 + 4, top - 8}, grid.columns[column].first,
             {.size = kGridText,
              .tone = grid.columns[column].second,
              .turned_deg = places.is_narrow ? 90.0 : kTurned_deg});
  for (std::size_t row = 0; row < grid.rows.size(); ++row)
    if (places.is_narrow)
      svg.text({places.left, y_of(row) - kNameAbove / 2 + 1}, grid.rows[row],
               {.size = kGridText, .tone = Tone::ink});
    else
      svg.text({places.left - 10, y_of(row) + kRow / 2}, grid.rows[row],
               {.size = kGridText, .tone = Tone::ink, .side = Side::right});
  for (const Cell& cell : grid.cells) {
    if (cell.tone == Tone::none && cell.text.empty()) continue;
    const double x = x_of(cell.column) + 1, y = y_of(cell.row) + 1, room = places.column - 2;
    const Box box{x + cell.left * room, y, x + cell.right * room, y + kRow - 2};
    svg.box(box, colour_of(cell.tone));
    if (text_width(cell.text, kGridText) <= box.width() + 1)  // Else in the figure's data only.
      svg.text(box.centre(), cell.text, {.size = kGridText, .tone = Tone::ink, .side = Side::middle});
  }
  return top + places.row * static_cast<double>(grid.rows.size());
}

}  // namespace hyrax
