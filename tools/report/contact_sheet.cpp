#include "tools/report/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/result/number_text.h"
#include "tools/report/page_file.h"

namespace hyrax {
namespace {

struct StatusLook {
  int place = 0;  // In order of a sheet.
  std::string_view colour = {};
  std::string_view mark = {};
  double border = 0.0;
  Dash dash = Dash::solid;
};

StatusLook look_of(std::string_view status) {
  if (status == "agreed") return {2, "good", "✓", 1.5, Dash::solid};
  if (status == "played" || status == "missing") return {1, "notable", "–", 2.0, Dash::long_dashes};
  return {0, "bad", "✗", 4.0, Dash::solid};
}

void sort_by_status(std::vector<RunPanel>& panels) {
  std::ranges::stable_sort(panels, {}, [](const RunPanel& panel) { return look_of(panel.status).place; });
}

std::string verdict_of(const RunPanel& panel) {
  return fmt::format("{} {}", look_of(panel.status).mark, panel.status);
}

// Of a name, which has hyphens instead of blanks.
std::vector<std::string> name_lines(std::string_view name, double width, double size) {
  std::string spaced;
  for (const char letter : name) spaced.append(1, letter).append(letter == '-' ? " " : "");
  std::vector<std::string> lines = lines_of(spaced, width, size);
  for (std::string& line : lines)
    for (std::size_t at = line.find("- "); at != line.npos; at = line.find("- ", at)) line.erase(at + 1, 1);
  return lines;
}

// A bold text, smaller where it needs to be.
void draw_bold(Svg& svg, SvgPoint at, const std::string& text, double size, double width) {
  constexpr double kBold = 1.06;  // Wider letters.
  const double fitting = std::floor(size * std::min(1.0, width / (kBold * text_width(text, size))));
  svg.text(at, text, {.size = fitting, .tone = Tone::ink, .is_bold = true});
}

constexpr double kWide = 960.0, kNarrow = 420.0, kPanelGap = 12.0, kPanel = 218.0;
constexpr int kColumns = 4;

void draw_panel(Svg& svg, const RunPanel& panel, const Box& box, bool is_narrow) {
  const double kSize = is_narrow ? 11.0 : 13.0, kLine = kSize + 2.0, kIn = is_narrow ? 5.0 : 8.0;
  const StatusLook look = look_of(panel.status);
  const double width = box.width() - 2 * kIn;
  svg.begin(panel.name);
  svg.outline(box, {colour_named(look.colour), look.border, look.dash}, 6.0);
  double y = box.top + kIn + kLine / 2;
  for (const std::string& line : name_lines(panel.name, width, kSize)) {
    draw_bold(svg, {box.left + kIn, y}, line, kSize, width);
    y += kLine;
  }
  svg.text({box.left + kIn, y}, verdict_of(panel), {.size = kSize, .tone = Tone::ink});
  if (panel.picture.width > 0.0)
    svg.put(panel.picture, {box.left + kIn, y + kLine / 2 + 2, box.right - kIn, box.bottom - kIn});
  svg.end();
}

Sheet sheet_of(const std::vector<RunPanel>& panels, double width) {
  constexpr double kHead = 58.0, kPanelSide = 190.0;
  const double scale = width / kWide;
  const bool is_narrow = width < kWide;
  const auto rows = static_cast<double>((panels.size() + kColumns - 1) / kColumns);
  Sheet sheet{width, scale * (kHead + rows * (kPanelSide + kPanelGap) + kSheetMargin - kPanelGap)};
  draw_bold(sheet.svg, {scale * kSheetMargin, scale * 34}, sheet_title(panels), is_narrow ? 15.0 : 20.0,
            width - 2 * scale * kSheetMargin);
  for (std::size_t index = 0; index < panels.size(); ++index) {
    const double left = kSheetMargin + static_cast<double>(index % kColumns) * (kPanel + kPanelGap);
    const double top = kHead + static_cast<double>(index / kColumns) * (kPanelSide + kPanelGap);
    draw_panel(sheet.svg, panels[index],
               {scale * left, scale * top, scale * (left + kPanel), scale * (top + kPanelSide)}, is_narrow);
  }
  return sheet;
}

}  // namespace

Sheet plot_panel(const Plot& plot) {
  constexpr double kDetail = 1.0, kEdge = 4.0;
  Box ends{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  const auto each_point = [&plot](const auto& take) {
    for (const Series& series : plot.series)
      for (std::size_t at = 0; at < series.x.size(); ++at)
        if (const double y = plot.y.is_reversed ? series.y[at] : -series.y[at];
            std::isfinite(series.x[at] + y))
          take(series, SvgPoint{series.x[at], y});
  };
  each_point([&ends](const Series&, SvgPoint at) {
    ends = {std::min(ends.left, at.x), std::min(ends.top, at.y), std::max(ends.right, at.x),
            std::max(ends.bottom, at.y)};
  });
  if (!(ends.left <= ends.right)) return {};
  const auto scale_of = [](double room, double length) {
    return (room - 2 * kEdge) / std::max(length, 1e-9);
  };
  double scale_x = scale_of(kPanelWidth, ends.width()), scale_y = scale_of(kPanelHeight, ends.height());
  if (plot.has_equal_scales) scale_x = scale_y = std::min(scale_x, scale_y);
  Sheet sheet{ends.width() * scale_x + 2 * kEdge, ends.height() * scale_y + 2 * kEdge};
  std::map<const Series*, std::vector<SvgPoint>> shown;
  each_point([&](const Series& series, SvgPoint at) {
    const SvgPoint to{kEdge + (at.x - ends.left) * scale_x, kEdge + (at.y - ends.top) * scale_y};
    std::vector<SvgPoint>& points = shown[&series];
    if (points.empty() || std::hypot(to.x - points.back().x, to.y - points.back().y) >= kDetail)
      points.push_back(to);
  });
  for (const Series& series : plot.series) {
    const std::string& colour = colour_of(series.look.tone);
    if (series.look.form != Form::points) sheet.svg.line(shown[&series], {colour, 1.5, series.look.dash});
    if (series.look.form != Form::line)
      for (const SvgPoint& at : shown[&series]) sheet.svg.sign(at, series.look.marker, 0.6, colour);
  }
  return sheet;
}

std::string sheet_title(const std::vector<RunPanel>& panels) {
  std::string text;
  for (const char* const status : {"disagreed", "failed", "missing", "played", "agreed"})
    if (const auto count = std::ranges::count(panels, status, &RunPanel::status); count > 0)
      text += fmt::format("{} {} {}", text.empty() ? ":" : ",", with_decimals(static_cast<double>(count), 0),
                          status);
  return counted(panels.size(), "scenario") + text;
}

std::string contact_sheet_svg(std::vector<RunPanel> panels) {
  sort_by_status(panels);
  const Sheet wide = sheet_of(panels, kWide), narrow = sheet_of(panels, kNarrow);
  return svg_text(sheet_title(panels), wide, &narrow);
}

std::string contact_sheet_html(std::vector<RunPanel> panels, bool has_title) {
  sort_by_status(panels);
  std::string html = "<section id=\"runs\" class=\"sheet\" aria-label=\"All runs\">\n" +
                     html_line("h1", has_title ? sheet_title(panels) : "");
  for (const RunPanel& panel : panels) {
    const bool is_link = !panel.link.empty();
    html += is_link ? fmt::format("<a class=\"panel {}\" href=\"{}\">", look_of(panel.status).colour,
                                  escaped(panel.link))
                    : fmt::format("<details class=\"panel {}\"><summary>", look_of(panel.status).colour);
    html += html_line("b", panel.name) + html_line("span", verdict_of(panel));
    if (panel.picture.width > 0.0) html += svg_element(panel.name, "picture-of-run", panel.picture, 0.0);
    html += is_link ? "</a>\n"
                    : "</summary>\n" + html_line("p", panel.text) + html_line("code", panel.command) +
                          "</details>\n";
  }
  return html + "<style>" + dark_rules(html) + "</style>\n</section>\n";
}

}  // namespace hyrax
