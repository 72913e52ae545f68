// The look that all figures share: a card with round corners, light as drawn here and dark by svg.h, and
// colours that colour-blind readers tell apart.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

/// Size of a figure in px of the SVG.
struct Canvas {
  double width = 960;
  double height = 600;
};

namespace style {

inline constexpr std::string_view kInk = "#24292f";
inline constexpr std::string_view kQuietInk = "#6a737d";  ///< 4.6:1 on the card: axes, notes.
inline constexpr std::string_view kFaintInk = "#a3adb8";  ///< Outlines that stand behind others.
inline constexpr std::string_view kHairline = "#d0d7de";
inline constexpr std::string_view kCard = "#f6f8fa";
inline constexpr std::string_view kPaper = "#ffffff";  ///< Where data are drawn.

// Okabe and Ito, "Color Universal Design", 2008.
inline constexpr std::string_view kBlue = "#0072b2";
inline constexpr std::string_view kVermilion = "#d55e00";
inline constexpr std::string_view kGreen = "#009e73";
inline constexpr std::string_view kPurple = "#cc79a7";
inline constexpr std::string_view kOrange = "#e69f00";
inline constexpr std::string_view kSkyBlue = "#56b4e9";
// Unlike every colour of a wall, and lighter than what is drawn over it.
inline constexpr std::string_view kLavender = "#aa8fd8";
// Pale, behind text.
inline constexpr std::string_view kGood = "#cfe8df";
inline constexpr std::string_view kNotable = "#f6dfa9";
inline constexpr std::string_view kBad = "#f1b594";
inline constexpr std::string_view kShade = "#eaeef2";
inline constexpr std::string_view kBeads = "#26828e";  ///< The middle of viridis.

inline constexpr double kLabelSize = 11;  ///< Of letters among data, in px: in no other text.
inline constexpr double kMargin = 28;     ///< From the card's edge to text, in px.

}  // namespace style

/// The first lines of every script: the title as a comment, which becomes the SVG's `<title>`, terminal,
/// fonts, card, quiet axes, title and subtitle. A title that is wider than the card is drawn smaller. A note
/// stands at the right: what the reader must know lest the figure mislead. Labels 1 .. 9 and object 1 are the
/// head's.
[[nodiscard]] std::string figure_head(const Canvas& canvas, std::string_view title, std::string_view subtitle,
                                      std::string_view note = {},
                                      std::string_view note_colour = style::kVermilion);

/// `set palette` with viridis (van der Walt and Smith, 2015) without its palest third, which would be
/// lost on paper.
[[nodiscard]] std::string viridis();

/// Text as gnuplot reads it; control characters become blanks.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// A place on the canvas, x from its left edge and y from its top, as gnuplot reads it.
[[nodiscard]] std::string screen(const Canvas& canvas, double x, double y);

/// An arrow in ink from x, y to x + dx, y + dy on the canvas.
[[nodiscard]] std::string arrow(const Canvas& canvas, double x, double y, double dx, double dy);

}  // namespace hyrax
