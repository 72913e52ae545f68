#include "tools/report/figure_script.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "tools/report/figure_body.h"

namespace hyrax {
namespace {

constexpr double kLegendLine = 24;  // All in px of the SVG.
constexpr double kRemarkLine = 22;
constexpr double kAboveRemarks = 8;
constexpr double kSign = 32;  // From a sign of the legend to its text.
constexpr double kEntryGap = 18;
constexpr double kFootHeight = 26;

// Where each entry of the legend is: in one row if there is room, else in columns.
struct LegendPlaces {
  std::vector<std::pair<double, double>> places;  // x from the canvas's left edge, y from the legend's top.
  double height = 0.0;
};

LegendPlaces place_legend(const std::vector<LegendEntry>& entries, double width) {
  LegendPlaces legend;
  std::vector<double> widths;
  for (const LegendEntry& entry : entries)
    widths.push_back(kSign + kLetter_px * static_cast<double>(letters_of(entry.text)) + kEntryGap);
  const double room = width - style::kMargin;
  const bool is_row = std::accumulate(widths.begin(), widths.end(), 0.0) <= room;
  const double widest = entries.empty() ? room : *std::max_element(widths.begin(), widths.end());
  const std::size_t columns =
      is_row ? entries.size() : static_cast<std::size_t>(std::max(1.0, room / widest));
  const std::size_t rows = columns == 0 ? 0 : (entries.size() + columns - 1) / columns;
  double x = style::kMargin;
  for (std::size_t index = 0; index < entries.size(); ++index) {
    legend.places.emplace_back(x, kLegendLine * static_cast<double>(index % rows));
    if (index % rows == rows - 1) x += is_row ? widths[index] : room / static_cast<double>(columns);
  }
  legend.height = kLegendLine * static_cast<double>(rows);
  return legend;
}

std::string sign(const Canvas& canvas, const Look& look, double x, double y) {
  const std::string_view colour = colour_of(look.tone);
  if (look.form == Form::points)
    return fmt::format("set label '' at {} point {} lc rgb '{}'\n", screen(canvas, x + 12, y),
                       marker_of(look), colour);
  if (look.form == Form::band || look.form == Form::bars)
    return fmt::format("set object rectangle from {} to {} fs solid 1 border lc rgb '{}' fc rgb '{}'\n",
                       screen(canvas, x, y - 7), screen(canvas, x + 24, y + 7), style::kHairline, colour);
  return fmt::format("set arrow from {} to {} nohead {} lc rgb '{}'\n", screen(canvas, x, y),
                     screen(canvas, x + 24, y), stroke_of(look), colour);
}

// Lines no longer than a remark's room, broken at blanks.
std::vector<std::string> lines_of(const std::vector<std::string>& remarks, double width) {
  const auto room = static_cast<std::size_t>((width - 2 * style::kMargin) / kLetter_px);
  std::vector<std::string> lines;
  for (std::string rest : remarks) {
    while (rest.size() > room && rest.rfind(' ', room) != rest.npos) {
      const std::size_t blank = rest.rfind(' ', room);
      lines.push_back(rest.substr(0, blank));
      rest = rest.substr(blank + 1);
    }
    lines.push_back(rest);
  }
  return lines;
}

}  // namespace

std::string_view colour_of(Tone tone) {
  constexpr std::array<std::string_view, 16> kColours = {
      style::kInk,       style::kQuietInk, style::kFaintInk, style::kHairline,
      style::kVermilion, style::kOrange,   style::kBlue,     style::kGreen,
      style::kPurple,    style::kSkyBlue,  style::kLavender, style::kGood,
      style::kNotable,   style::kBad,      style::kShade,    style::kPaper};
  return kColours[static_cast<std::size_t>(tone)];
}

std::string marker_of(const Look& look) {
  constexpr std::array<int, 3> kPointTypes = {7, 6, 4};
  return fmt::format("pt {} ps {:g}", kPointTypes[static_cast<std::size_t>(look.marker)], look.marker_size);
}

std::string stroke_of(const Look& look) {
  constexpr std::array<std::string_view, 3> kDashes = {"solid", "(4,4)", "(8,4)"};
  return fmt::format("lw {:g} dt {}", look.width_px, kDashes[static_cast<std::size_t>(look.dash)]);
}

std::size_t letters_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xc0) != 0x80; }));
}

std::string figure_script(const Figure& figure) {
  const Canvas body = std::visit([](const auto& each) { return body_size(each); }, figure.body);
  const LegendPlaces legend = place_legend(figure.legend, body.width);
  const std::vector<std::string> remarks = lines_of(figure.remarks, body.width);
  const double remarks_height =
      remarks.empty() ? 0.0 : kAboveRemarks + kRemarkLine * static_cast<double>(remarks.size());
  const Canvas canvas{body.width, kBodyTop + body.height + legend.height + remarks_height + kFootHeight};
  std::string script =
      figure_head(canvas, figure.title, figure.subtitle, figure.note, colour_of(figure.note_tone));
  double y = kBodyTop + body.height + kLegendLine / 2;
  for (std::size_t index = 0; index < figure.legend.size(); ++index) {
    const auto [entry_x, entry_y] = legend.places[index];
    script += sign(canvas, figure.legend[index].look, entry_x, y + entry_y);
    script += fmt::format("set label {} at {} left tc rgb '{}'\n", in_quotes(figure.legend[index].text),
                          screen(canvas, entry_x + kSign, y + entry_y), style::kQuietInk);
  }
  y += legend.height + kAboveRemarks;
  for (const std::string& remark : remarks) {
    script += fmt::format("set label {} at {} left tc rgb '{}'\n", in_quotes(remark),
                          screen(canvas, style::kMargin, y), style::kVermilion);
    y += kRemarkLine;
  }
  return script + std::visit([&](const auto& each) { return body_script(each, canvas); }, figure.body);
}

}  // namespace hyrax
