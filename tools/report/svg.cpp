#include "tools/report/svg.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace hyrax {

std::string escaped(std::string_view text, bool keeps_lines) {
  std::string result;
  for (const char letter : text) {
    if (letter == '<')
      result += "&lt;";
    else if (letter == '&')
      result += "&amp;";
    else if (letter == '"')
      result += "&quot;";
    else if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f)
      result += keeps_lines && letter == '\n' ? '\n' : ' ';
    else
      result += letter;
  }
  return result;
}

namespace {

constexpr std::string_view kLetters =
    "font-family=\"Helvetica Neue,Helvetica,Arial,Liberation Sans,sans-serif\" stroke-linejoin=\"round\"";

// A length of the picture, to a twentieth of a px.
std::string px(double length) {
  const double rounded = std::round(length * 20.0) / 20.0;
  return fmt::format("{:g}", rounded == 0.0 ? 0.0 : rounded);
}

bool is_drawn(SvgPoint at) { return std::isfinite(at.x) && std::isfinite(at.y); }

// Points beyond it, which a viewer may not be able to draw, come nearer.
SvgPoint within_reach(SvgPoint at) {
  constexpr double kFar = 20'000.0;
  return {std::clamp(at.x, -kFar, kFar), std::clamp(at.y, -kFar, kFar)};
}

std::string path_of(const std::vector<SvgPoint>& points) {
  std::string path;
  bool is_continued = false;
  for (const SvgPoint& point : points) {
    if (!is_drawn(point)) {
      is_continued = false;
      continue;
    }
    const SvgPoint at = within_reach(point);
    path += fmt::format("{}{},{}", is_continued ? " " : "M", px(at.x), px(at.y));
    is_continued = true;
  }
  return path;
}

std::string stroke_of(const Pen& pen) {
  const std::string& dashes = dashes_of(pen.dash);
  return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\"{}", pen.colour, pen.width,
                     dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dashes));
}

std::string place_of(const Box& box) {
  return fmt::format("x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", px(box.left), px(box.top),
                     px(std::max(0.0, box.width())), px(std::max(0.0, box.height())));
}

std::string rounded_by(double corner) {
  return corner > 0.0 ? fmt::format(" rx=\"{}\"", px(corner)) : std::string();
}

// A hyphen before a number is its sign.
std::string with_minus_signs(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool begins = at == 0 || text[at - 1] == ' ' || text[at - 1] == '(';
    const bool is_sign =
        text[at] == '-' && begins && at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9';
    result += is_sign ? std::string_view("−") : text.substr(at, 1);
  }
  return result;
}

}  // namespace

void Svg::line(const std::vector<SvgPoint>& points, const Pen& pen) {
  body_ += fmt::format("<path d=\"{}\" {}/>\n", path_of(points), stroke_of(pen));
}

void Svg::area(const std::vector<SvgPoint>& corners, std::string_view colour, double opacity) {
  body_ +=
      fmt::format("<path d=\"{}Z\" fill=\"{}\" fill-opacity=\"{:g}\"/>\n", path_of(corners), colour, opacity);
}

void Svg::box(const Box& box, std::string_view colour, double corner, double opacity) {
  body_ += fmt::format("<rect {}{} fill=\"{}\"{}/>\n", place_of(box), rounded_by(corner), colour,
                       opacity < 1.0 ? fmt::format(" fill-opacity=\"{:g}\"", opacity) : std::string());
}

void Svg::outline(const Box& box, const Pen& pen, double corner) {
  body_ += fmt::format("<rect {}{} {}/>\n", place_of(box), rounded_by(corner), stroke_of(pen));
}

void Svg::sign(SvgPoint at, Marker marker, double size, std::string_view colour, std::string_view tip) {
  if (!is_drawn(at)) return;
  const double half = 3.5 * size;
  const std::string title = tip.empty() ? "" : fmt::format("<title>{}</title>", escaped(tip));
  if (marker >= Marker::to_left) {  // The corners of a triangle, from -1 to 1.
    constexpr int kX[] = {-1, 1, 0, 0}, kY[] = {0, 0, -1, 1};
    const auto wall = static_cast<std::size_t>(marker) - static_cast<std::size_t>(Marker::to_left);
    const int x = kX[wall], y = kY[wall];
    const auto corner = [&](int to_x, int to_y) { return SvgPoint{at.x + half * to_x, at.y + half * to_y}; };
    body_ +=
        fmt::format("<path d=\"{}Z\" fill=\"{}\">{}</path>\n",
                    path_of({corner(x, y), corner(-x - y, x - y), corner(y - x, -x - y)}), colour, title);
  } else if (marker == Marker::square)
    body_ +=
        fmt::format("<rect {} {}>{}</rect>\n", place_of({at.x - half, at.y - half, at.x + half, at.y + half}),
                    stroke_of({colour, 1.5}), title);
  else
    body_ += fmt::format(
        "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}>{}</circle>\n", px(at.x), px(at.y), px(half),
        marker == Marker::ring ? stroke_of({colour, 1.5}) : fmt::format("fill=\"{}\"", colour), title);
}

void Svg::cross(SvgPoint at, double arm, const Pen& pen) {
  line({{at.x - arm, at.y - arm},
        {at.x + arm, at.y + arm},
        {kNotGiven, kNotGiven},
        {at.x - arm, at.y + arm},
        {at.x + arm, at.y - arm}},
       pen);
}

void Svg::arrow(SvgPoint from, SvgPoint to, std::string_view colour) {
  constexpr double kHead = 9.0, kHalf = 3.6;
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double dx = (to.x - from.x) / length, dy = (to.y - from.y) / length;
  const SvgPoint neck{to.x - kHead * dx, to.y - kHead * dy};
  line({from, neck}, {colour, 2.0});
  area({to, {neck.x - kHalf * dy, neck.y + kHalf * dx}, {neck.x + kHalf * dy, neck.y - kHalf * dx}}, colour);
}

void Svg::text(SvgPoint at, std::string_view text, const Lettering& lettering) {
  if (text.empty() || !is_drawn(at)) return;
  constexpr std::string_view kAnchors[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};
  constexpr double kHalfLetter = 0.35;
  const std::string x = px(at.x),
                    y = px(at.y + (lettering.turned_deg == 0.0 ? kHalfLetter * lettering.size : 0.0));
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{:g}\"{}{} fill=\"{}\"{}{}>{}</text>\n", x, y, lettering.size,
      kAnchors[static_cast<std::size_t>(lettering.side)], lettering.is_bold ? " font-weight=\"600\"" : "",
      colour_of(lettering.tone),
      lettering.has_edge
          ? fmt::format(" paint-order=\"stroke\" stroke=\"{}\" stroke-width=\"3\"", colour_named("card"))
          : "",
      lettering.turned_deg == 0.0
          ? ""
          : fmt::format(" transform=\"rotate({:g} {} {})\"", -lettering.turned_deg, x, y),
      escaped(with_minus_signs(text)));
}

void Svg::begin(std::string_view name) {
  body_ += fmt::format("<g data-series=\"{0}\"><title>{0}</title>\n", escaped(name));
}

void Svg::begin_clip(const Box& box, std::string_view data) {
  body_ += fmt::format("<svg {} viewBox=\"{} {} {} {}\"{}>\n", place_of(box), px(box.left), px(box.top),
                       px(box.width()), px(box.height()), data);
}

void Svg::put(const Sheet& sheet, const Box& box) {
  body_ += fmt::format("<svg {} viewBox=\"0 0 {} {}\">\n{}</svg>\n", place_of(box), px(sheet.width),
                       px(sheet.height), sheet.svg.body());
}

std::string dark_rules(const std::string& svg) {
  std::string rules;
  for (const auto& [light, dark] : light_and_dark())
    for (const std::string_view use : {"fill", "stroke"})
      if (const std::string place = fmt::format("{}=\"{}\"", use, light);
          svg.find(place) != svg.npos && rules.find(place) == rules.npos)
        rules += fmt::format("[{}]{{{}:{}}}", place, use, dark);
  return "@media screen and (prefers-color-scheme:dark){" + rules + "}";
}

std::string svg_element(std::string_view name, std::string_view css_class, const Sheet& sheet, double left) {
  return fmt::format(
      "<svg class=\"{0}\" width=\"{1}\" height=\"{2}\" viewBox=\"{3} 0 {1} {2}\" role=\"group\" "
      "aria-label=\"{4}\" {5}>\n{6}</svg>\n",
      css_class, px(sheet.width - left), px(sheet.height), px(left), escaped(name), kLetters,
      sheet.svg.body());
}

std::string svg_text(std::string_view title, const Sheet& sheet, const Sheet* narrow) {
  constexpr double kCorner = 12.0;
  Svg card;
  card.box({0.5, 0.5, sheet.width - 0.5, sheet.height - 0.5}, colour_named("card"), kCorner);
  card.outline({0.5, 0.5, sheet.width - 0.5, sheet.height - 0.5}, {colour_named("rule"), 1.0}, kCorner);
  std::string body = card.body() + "<g class=\"wide\">\n" + sheet.svg.body() + "</g>\n";
  std::string style;
  if (narrow != nullptr) {
    style = "@media (max-width:620px){.wide{display:none}.narrow{display:inline}}";
    body += fmt::format(
        "<svg class=\"narrow\" display=\"none\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {2} "
        "{3}\">\n{4}</svg>\n",
        px(sheet.width), px(sheet.height), px(narrow->width), px(narrow->height), narrow->svg.body());
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "role=\"img\" style=\"max-width:100%;height:auto\" "
      "{3}>\n<title>{2}</title>\n<style>{4}{5}</style>\n{6}</svg>\n",
      px(sheet.width), px(sheet.height), escaped(title), kLetters, style, dark_rules(body), body);
}

std::vector<std::string> lines_of(std::string_view text, double width, double size) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, blank));
    text.remove_prefix(std::min(blank + 1, text.size()));
    if (!line.empty() && text_width(line + " " + word, size) > width) {
      lines.push_back(std::move(line));
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

double draw_head(Svg& svg, double width, std::string_view title, std::string_view subtitle,
                 std::string_view note, Tone note_tone) {
  constexpr double kTitle = 20.0, kText = 13.0, kBold = 1.06;  // Wider letters.
  const double room = width - 2 * kSheetMargin;
  double y = 34.0;
  const double note_width = note.empty() ? 0.0 : text_width(note, kText) + 20.0;
  const bool is_beside = kBold * text_width(title, kTitle) + note_width <= room;
  if (is_beside)
    svg.text({width - kSheetMargin, y}, note, {.size = kText, .tone = note_tone, .side = Side::right});
  for (const std::string& line : lines_of(title, room / kBold, kTitle)) {
    const double fitting = std::floor(kTitle * std::min(1.0, room / (kBold * text_width(line, kTitle))));
    svg.text({kSheetMargin, y}, line, {.size = fitting, .tone = Tone::ink, .is_bold = true});
    y += 25.0;
  }
  const auto lines = [&](std::string_view text, Tone tone) {
    for (const std::string& line : lines_of(text, room, kText)) {
      svg.text({kSheetMargin, y}, line, {.size = kText, .tone = tone});
      y += 19.0;
    }
  };
  lines(subtitle, Tone::quiet);
  if (!is_beside) lines(note, note_tone);
  return y - 6.0;
}

}  // namespace hyrax
