#include "tools/report/figure_svg.h"

#include <algorithm>
#include <variant>

#include "tools/files/text_file.h"
#include "tools/report/figure_body.h"

namespace hyrax {

void draw_sign(Svg& svg, const Look& look, double x, double y) {
  const std::string& colour = colour_of(look.tone);
  const SvgPoint middle{x + kLegendSign / 2, y};
  if (look.form == Form::band || look.form == Form::bars) {
    const SvgBox box{x + 2, y - 6, x + kLegendSign - 2, y + 6};
    svg.box(box, colour, 2.0);
    svg.outline(box, {colour_of(Tone::hairline), 1.0}, 2.0);
    return;
  }
  if (look.form != Form::points) svg.line({{x, y}, {x + kLegendSign, y}}, {colour, look.width_px, look.dash});
  if (look.form != Form::line) svg.sign(middle, look.marker, std::max(look.marker_size, 0.8), colour);
}

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
    draw_sign(svg, entry.look, x, y);
    svg.text({x + kLegendSign + kSpace, y}, entry.text, {.size = kSize});
    x += kLegendSign + kSpace + text_width(entry.text, kSize) + kGap;
  }
  return y + kLine / 2 + kUnder;
}

std::string figure_svg(const Figure& figure) {
  constexpr double kRemark = 19.0, kSize = 13.0, kGap = 12.0;
  Sheet sheet;
  Svg& svg = sheet.svg;
  sheet.width = std::visit([](const auto& body) { return sheet_width(body); }, figure.body);
  double y = draw_head(svg, sheet.width, figure.title, figure.subtitle, figure.note, figure.note_tone) + kGap;
  y = draw_legend(svg, figure.legend, sheet.width, y);
  y = std::visit([&](const auto& body) { return draw_body(svg, body, sheet.width, y); }, figure.body);
  for (const std::string& remark : figure.remarks)
    for (const std::string& line : lines_of(remark, sheet.width - 2 * kSheetMargin, kSize)) {
      y += kRemark;
      svg.text({kSheetMargin, y}, line, {.size = kSize, .tone = Tone::ink});
    }
  sheet.height = y + kSheetMargin;
  return svg_text(figure.title, sheet);
}

void draw_figure(const std::string& path, const Figure& figure) { write_text_file(path, figure_svg(figure)); }

}  // namespace hyrax
