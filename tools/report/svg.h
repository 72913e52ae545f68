// An SVG picture: lines, areas, signs and text in px from its upper left corner.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/report/look.h"

namespace hyrax {

struct SvgPoint {
  double x = 0.0;
  double y = 0.0;
};

/// In px of the picture, or of the window that it shows.
struct Box {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
  [[nodiscard]] SvgPoint centre() const { return {(left + right) / 2, (top + bottom) / 2}; }
  /// Whether the point is inside; false if it is not finite.
  [[nodiscard]] bool holds(double x, double y) const {
    return x >= left && x <= right && y >= top && y <= bottom;
  }
};

struct Pen {
  std::string_view colour;  ///< As of look.h.
  double width = 1.5;
  Dash dash = Dash::solid;
};

enum class Side : std::uint8_t { left, middle, right };

struct Lettering {
  double size = 13.0;
  Tone tone = Tone::quiet;
  Side side = Side::left;  ///< Which part of the text is at its place.
  bool is_bold = false;
  bool has_edge = false;    ///< Of the card's colour, by which it is readable over a line.
  double turned_deg = 0.0;  ///< Upwards.
};

struct Sheet;

class Svg {
 public:
  /// A point that is not finite interrupts the line.
  void line(const std::vector<SvgPoint>& points, const Pen& pen);
  void area(const std::vector<SvgPoint>& corners, std::string_view colour, double opacity = 1.0);
  void box(const Box& box, std::string_view colour, double corner = 0.0, double opacity = 1.0);
  void outline(const Box& box, const Pen& pen, double corner = 0.0);
  /// @param tip what a viewer shows of it under the pointer; may be empty.
  void sign(SvgPoint at, Marker marker, double size, std::string_view colour, std::string_view tip = {});
  void cross(SvgPoint at, double arm, const Pen& pen);
  /// REQUIRES: longer than its head, 9 px.
  void arrow(SvgPoint from, SvgPoint to, std::string_view colour);
  /// The place is at half the height of its letters. Control characters become blanks.
  void text(SvgPoint at, std::string_view text, const Lettering& lettering);

  /// What follows belongs to a series of that name, until `end`: a viewer shows the name under the pointer, a
  /// page lights all that is of it.
  void begin(std::string_view name);
  void end() { body_ += "</g>\n"; }
  /// What follows is drawn inside the box only, until `end_clip`.
  /// @param data attributes for the scripts of pages, escaped; may be empty.
  void begin_clip(const Box& box, std::string_view data = {});
  void end_clip() { body_ += "</svg>\n"; }
  /// Another drawing, as large as the box has room for.
  void put(const Sheet& sheet, const Box& box);

  [[nodiscard]] const std::string& body() const { return body_; }

 private:
  std::string body_;
};

/// A text as XML and HTML show it. Control characters become blanks; @param keeps_lines line ends do not.
[[nodiscard]] std::string escaped(std::string_view text, bool keeps_lines = false);

/// What is drawn, with its size.
struct Sheet {
  double width = 0.0;
  double height = 0.0;
  Svg svg = {};
};

/// The text of an SVG file: a card with the sheet on it, light or dark as its reader prefers.
/// @param narrow of the same proportions: takes the first one's place where that would be too small to read.
[[nodiscard]] std::string svg_text(std::string_view title, const Sheet& sheet, const Sheet* narrow = nullptr);

/// A sheet as an element of an HTML page that has the rules of dark_rules for it, from `left` on.
[[nodiscard]] std::string svg_element(std::string_view name, std::string_view css_class, const Sheet& sheet,
                                      double left);

/// CSS that puts each dark colour in the place of its light one, as look.css does.
[[nodiscard]] std::string dark_rules(const std::string& svg);

/// Lines of text no wider than `width`, broken at blanks.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text, double width, double size);

/// Draws title, subtitle and note at the top of a sheet of that width; returns where they end.
double draw_head(Svg& svg, double width, std::string_view title, std::string_view subtitle,
                 std::string_view note, Tone note_tone);

inline constexpr double kSheetMargin = 26.0;  ///< From the card's edge to text, in px.

}  // namespace hyrax
