// Results as text that a person can review: of a table each column with its unit and the values it has, of a
// figure each axis, legend and series. A test compares it with the text that was approved.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "sim/result/figure.h"
#include "sim/result/result.h"
#include "sim/result/table.h"

namespace hyrax {

// What is next to nothing may be rounding, which a compiler or a library decides: it is 0.
inline std::string six_digits(double value) {
  if (std::fabs(value) < 1e-9) return "0";
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.6g", value))};
}

// How many, and each of a few; of many first .. last, least .. most, the mean and the mean weighted by place,
// which an exchange of two changes. NaN is a missing value.
inline std::string described(const std::vector<double>& values) {
  constexpr std::size_t kShownMax = 8;
  std::vector<double> known;
  std::copy_if(values.begin(), values.end(), std::back_inserter(known),
               [](double value) { return !std::isnan(value); });
  std::string text = std::to_string(values.size());
  if (known.size() != values.size())
    text += " (" + std::to_string(values.size() - known.size()) + " missing)";
  if (known.empty()) return text;
  if (known.size() <= kShownMax) {
    text += ":";
    for (const double value : known) text += " " + six_digits(value);
    return text;
  }
  const auto count = static_cast<double>(known.size());
  double mean = 0.0, by_place = 0.0;
  for (std::size_t at = 0; at < known.size(); ++at) {
    mean += known[at] / count;
    by_place += known[at] / count * (static_cast<double>(at) / count);
  }
  const auto [least, most] = std::minmax_element(known.begin(), known.end());
  text += ": " + six_digits(known.front()) + " .. " + six_digits(known.back());
  if (*least == *most) return text;
  return text + " in " + six_digits(*least) + " .. " + six_digits(*most) + ", mean " + six_digits(mean) +
         ", by place " + six_digits(by_place);
}

// Each text once, in order, with how often it stands there.
inline std::string described(const std::vector<std::string>& texts) {
  constexpr std::size_t kShownMax = 40;
  std::vector<std::pair<std::string, int>> counts;
  for (const std::string& text : texts) {
    const auto known =
        std::find_if(counts.begin(), counts.end(), [&](const auto& each) { return each.first == text; });
    (known == counts.end() ? counts.emplace_back(text, 0) : *known).second += 1;
  }
  std::string all = std::to_string(texts.size()) + ":";
  for (std::size_t at = 0; at < std::min(counts.size(), kShownMax); ++at)
    all += " '" + counts[at].first + "'" +
           (counts[at].second > 1 ? " x" + std::to_string(counts[at].second) : "");
  return all +
         (counts.size() > kShownMax ? " and " + std::to_string(counts.size() - kShownMax) + " more" : "");
}

inline std::string described(const Table& table, const std::string& indent = "");

inline std::string described(const Column& column, const std::string& indent) {
  std::string text = indent + "  " + column.name + (column.unit.empty() ? "" : ", " + column.unit);
  if (!column.key.empty()) text += " [" + column.key + "]";
  text += ": " + column.long_name +
          (column.digits == 4 ? "" : ", " + std::to_string(column.digits) + " digits") + ": ";
  std::vector<double> numbers;
  std::vector<std::string> texts;
  std::string tables;
  for (std::size_t row = 0; row < length(column); ++row)
    std::visit(
        [&](const auto& values) {
          using Value = std::decay_t<decltype(values[row])>;
          if constexpr (std::is_same_v<Value, Table>)
            tables +=
                row == 0 || row + 1 == values.size() ? "\n" + described(values[row], indent + "    ") : "";
          else if constexpr (std::is_convertible_v<Value, std::string_view>)
            texts.emplace_back(values[row]);
          else if constexpr (std::is_same_v<Value, std::optional<std::int64_t>>)
            numbers.push_back(values[row] ? static_cast<double>(*values[row]) : kNotGiven);
          else
            numbers.push_back(static_cast<double>(values[row]));
        },
        column.values);
  if (!tables.empty()) return text + "first and last" + tables;
  return text + (texts.empty() ? described(numbers) : described(texts)) + "\n";
}

inline std::string described(const Table& table, const std::string& indent) {
  constexpr const char* kForms[] = {"", " (values)", " (by first)", " (one)", " (members)"};
  std::string text = indent + "table " + table.name + kForms[static_cast<std::size_t>(table.form)] + ": " +
                     table.long_name + "\n";
  for (const Column& column : table.columns) text += described(column, indent);
  return text;
}

inline std::string described(Tone tone) {
  constexpr const char* kNames[] = {"ink",     "quiet",  "faint",  "hairline", "vermilion", "orange",
                                    "blue",    "green",  "purple", "sky_blue", "lavender",  "good",
                                    "notable", "bad",    "shade",  "none",     "ramp_1",    "ramp_2",
                                    "ramp_3",  "ramp_4", "ramp_5", "ramp_6"};
  return kNames[static_cast<std::size_t>(tone)];
}

inline std::string described(Marker marker) {
  constexpr const char* kMarkers[] = {"dot", "ring", "square", "to left", "to right", "to top", "to ground"};
  return kMarkers[static_cast<std::size_t>(marker)];
}

inline std::string described(const Look& look) {
  constexpr const char* kForms[] = {"line", "points", "line and points", "band", "bars"};
  constexpr const char* kDashes[] = {"", " short dashes", " long dashes", " dots"};
  return described(look.tone) + " " + kForms[static_cast<std::size_t>(look.form)] +
         kDashes[static_cast<std::size_t>(look.dash)] + " " + six_digits(look.width_px) + " " +
         described(look.marker) + " " + six_digits(look.marker_size);
}

inline std::string described(const Axis& axis) {
  std::string text = "'" + axis.label + "'" + (axis.is_logarithmic ? " logarithmic" : "") +
                     (axis.is_reversed ? " reversed" : "") +
                     (axis.decimals < 0 ? "" : " decimals " + std::to_string(axis.decimals));
  if (!std::isnan(axis.low) || !std::isnan(axis.high))
    text += " " + six_digits(axis.low) + " .. " + six_digits(axis.high);
  if (!std::isnan(axis.zero_at)) text += " '" + axis.zero_text + "' at " + six_digits(axis.zero_at);
  if (!std::isnan(axis.strip_below))
    text += " strip '" + axis.strip_name + "' below " + six_digits(axis.strip_below);
  for (const Tick& tick : axis.ticks) text += " " + six_digits(tick.at) + "=" + tick.text;
  return axis.categories.empty() ? text : text + " " + described(axis.categories);
}

inline std::string described(const std::vector<Plot>& plots) {
  std::string text;
  for (const Plot& plot : plots) {
    text += std::string("  plot") + (plot.has_equal_scales ? ", equal scales" : "") + ", if empty '" +
            plot.when_empty + "'\n    x " + described(plot.x) + "\n    y " + described(plot.y) + "\n";
    for (const Series& series : plot.series) {
      text += "    series '" + series.name + "': " + described(series.look) + "\n      x " +
              described(series.x) + "\n      y " + described(series.y) + "\n";
      if (!series.y_low.empty()) text += "      y_low " + described(series.y_low) + "\n";
      if (!series.x_low.empty())
        text += "      x_low " + described(series.x_low) + "; x_high " + described(series.x_high) + "\n";
      if (!series.point_names.empty()) text += "      points " + described(series.point_names) + "\n";
    }
    for (const Mark& mark : plot.marks)
      text += std::string("    mark ") + (mark.is_vertical ? "x " : "y ") + six_digits(mark.at) + " '" +
              mark.text + "' " + described(mark.tone) + "\n";
    for (const PointText& point : plot.texts)
      text += "    text " + six_digits(point.x) + ", " + six_digits(point.y) + " '" + point.text + "' " +
              described(point.tone) + "\n";
    for (const Span& span : plot.spans)
      text += "    span " + six_digits(span.from) + " .. " + six_digits(span.to) + "\n";
    for (const TopDot& dot : plot.top_dots)
      text += "    " + described(dot.marker) + " " + six_digits(dot.x) + " " + described(dot.tone) + "\n";
  }
  return text;
}

inline std::string described(const Grid& grid) {
  std::string text = "  rows " + described(grid.rows) + "\n";
  for (const auto& [name, tone] : grid.columns) text += "  column '" + name + "' " + described(tone) + "\n";
  const auto look_of = [](const Cell& cell) {
    return " " + described(cell.tone) + " '" + cell.text + "' " + six_digits(cell.left) + " .. " +
           six_digits(cell.right) + "\n";
  };
  for (std::size_t at = 0, end = 0; at < grid.cells.size(); at = end) {  // Equal neighbours in one line.
    const Cell& cell = grid.cells[at];
    for (end = at + 1; end < grid.cells.size() && grid.cells[end].row == cell.row &&
                       grid.cells[end].column == cell.column + (end - at) &&
                       look_of(grid.cells[end]) == look_of(cell);)
      ++end;
    text += "  cell " + std::to_string(cell.row) + ", " + std::to_string(cell.column) +
            (end - at > 1 ? " .. " + std::to_string(cell.column + (end - at) - 1) : "") + look_of(cell);
  }
  return text;
}

inline std::string described(const Figure& figure) {
  std::string text = "figure " + figure.suffix + " '" + figure.title + "'\n  " + figure.subtitle + "\n";
  if (!figure.note.empty()) text += "  note " + figure.note + " " + described(figure.note_tone) + "\n";
  for (const LegendEntry& entry : figure.legend)
    text += "  legend '" + entry.text + "': " + described(entry.look) + "\n";
  text += std::visit([](const auto& body) { return described(body); }, figure.body);
  for (const std::string& remark : figure.remarks) text += "  remark " + remark + "\n";
  return text;
}

inline std::string described(const Verdict& verdict) {
  std::string text = "verdict " + verdict.answer + "\n";
  for (const auto& part : verdict.text) {
    const Table* const table = std::get_if<Table>(&part);
    text += table != nullptr ? described(*table, "  ") : "  " + std::get<std::string>(part) + "\n";
  }
  if (!verdict.brief.empty()) text += "  brief: " + verdict.brief + "\n";
  for (const std::string& sentence : verdict.broken) text += "  broken: " + sentence + "\n";
  return text;
}

// The text is that of the file, a path in the project. With HYRAX_APPROVE=1 the file becomes the text, to be
// reviewed as a difference of the commit.
inline void expect_approved(const std::string& file, const std::string& text) {
  const std::string path = std::string(HYRAX_SOURCE_DIR) + "/" + file;
  if (std::getenv("HYRAX_APPROVE") != nullptr) std::ofstream(path) << text;
  std::ifstream approved(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator(approved), {}), text)
      << file << " is what was approved; HYRAX_APPROVE=1 with this test writes it";
}

}  // namespace hyrax
