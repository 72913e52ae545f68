#include "tools/report/figure_svg.h"

#include <algorithm>
#include <variant>

#include "tools/files/text_file.h"
#include "tools/report/figure_body.h"

namespace hyrax {

double opacity_of(const Look& look) {
  const bool is_hue = look.tone >= Tone::vermilion && look.tone <= Tone::lavender;
  return look.form == Form::band && is_hue ? 0.5 : 1.0;
}

namespace {

constexpr double kLegendSign = 24.0;

// The sign of a look in a legend, between x and x + kLegendSign.
void draw_sign(Svg& svg, const Look& look, double x, double y) {
  const std::string& colour = colour_of(look.tone);
  const SvgPoint middle{x + kLegendSign / 2, y};
  if (look.form == Form::band || look.form == Form::bars) {
    const Box box{x + 2, y - 6, x + kLegendSign - 2, y + 6};
    svg.box(box, colour, 2.0, opacity_of(look));
    svg.outline(box, {colour_of(Tone::hairline), 1.0}, 2.0);
    return;
  }
  if (look.form != Form::points) svg.line({{x, y}, {x + kLegendSign, y}}, {colour, look.width_px, look.dash});
  if (look.form != Form::line) svg.sign(middle, look.marker, std::max(look.marker_size, 0.8), colour);
}

// Draws legend and body from `top` on; returns where they end.
double draw_data(Svg& svg, const Figure& figure, double width, double top) {
  const double start = draw_legend(svg, figure.legend, width, top);
  return std::visit([&](const auto& body) { return draw_body(svg, body, width, start); }, figure.body);
}

}  // namespace

double draw_legend(Svg& svg, const std::vector<LegendEntry>& entries, double width, double top) {
  constexpr double kLine = 20.0, kUnder = 8.0, kGap = 20.0, kSpace = 7.0, kSize = 13.0;
  if (entries.empty()) return top;
  double x = kSheetMargin, y = top + kLine / 2;
  for (const LegendEntry& entry : entries) {
    const double end = x + kLegendSign + kSpace + text_width(entry.text, kSize);
    if (end > width - kSheetMargin && x > kSheetMargin) {
      x = kSheetMargin;
      y += kLine;
    }
    svg.begin(entry.text);
    draw_sign(svg, entry.look, x, y);
    x += kLegendSign + kSpace;
    double widest = 0.0;
    const std::vector<std::string> lines = lines_of(entry.text, width - kSheetMargin - x, kSize);
    for (std::size_t line = 0; line < lines.size(); ++line) {
      if (line > 0) y += kSize + 2;
      svg.text({x, y}, lines[line], {.size = kSize});
      widest = std::max(widest, text_width(lines[line], kSize));
    }
    svg.end();
    x += widest + kGap;
  }
  return y + kLine / 2 + kUnder;
}

std::string figure_svg(const Figure& figure) {
  constexpr double kRemark = 19.0, kSize = 13.0, kGap = 12.0;
  Sheet sheet;
  Svg& svg = sheet.svg;
  sheet.width = std::visit([](const auto& body) { return sheet_width(body); }, figure.body);
  double y = draw_head(svg, sheet.width, figure.title, figure.subtitle, figure.note, figure.note_tone) + kGap;
  y = draw_data(svg, figure, sheet.width, y);
  for (const std::string& remark : figure.remarks)
    for (const std::string& line : lines_of(remark, sheet.width - 2 * kSheetMargin, kSize)) {
      y += kRemark;
      svg.text({kSheetMargin, y}, line, {.size = kSize, .tone = Tone::ink});
    }
  sheet.height = y + kSheetMargin;
  return svg_text(figure.title, sheet);
}

std::string figure_html(const Figure& figure) {
  constexpr double kLeft = kSheetMargin - 12;  // Before a sheet's texts; a font may be wider than text_width.
  std::string html = "<div class=\"picture\"";
  if (figure.row_count > 0) html += " data-rows=\"" + std::to_string(figure.row_count) + "\"";
  html += ">\n";
  const auto add = [&](const char* css_class, double width) {
    Sheet sheet{.width = width};
    sheet.height = draw_data(sheet.svg, figure, width, 0.0) + 4;
    html += svg_element(figure.title, css_class, sheet, kLeft);
  };
  add("narrow", 320 + kLeft);
  add("medium", 680 + kLeft);
  add("wide", 1080 + kLeft);
  return html + "<style>" + dark_rules(html) + "</style>\n</div>\n";
}

void draw_figure(const std::string& path, const Figure& figure) { write_text_file(path, figure_svg(figure)); }

}  // namespace hyrax
