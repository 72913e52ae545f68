// The three bodies that a figure may have, each measured and then drawn below the figure's head.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/result/figure.h"
#include "tools/report/figure_style.h"

namespace hyrax {

inline constexpr double kBodyTop = 118;  ///< From the canvas's upper edge to the body, in px of the SVG.

/// Room of a body in px of the SVG: of the whole canvas's width, and from kBodyTop to the body's lower end
/// (of plots the x axis's label included).
[[nodiscard]] Canvas body_size(const std::vector<Plot>& plots);
[[nodiscard]] Canvas body_size(const Grid& grid);
[[nodiscard]] Canvas body_size(const Listing& listing);

/// gnuplot's commands from the head's end on; the last one plots.
[[nodiscard]] std::string body_script(const std::vector<Plot>& plots, const Canvas& canvas);
[[nodiscard]] std::string body_script(const Grid& grid, const Canvas& canvas);
[[nodiscard]] std::string body_script(const Listing& listing, const Canvas& canvas);

[[nodiscard]] std::string_view colour_of(Tone tone);
/// gnuplot's "pt 7 ps 0.6", "lw 2.5 dt (4,4)".
[[nodiscard]] std::string marker_of(const Look& look);
[[nodiscard]] std::string stroke_of(const Look& look);

/// Letters of UTF-8 text, which at 14 px are about kLetter_px wide.
[[nodiscard]] std::size_t letters_of(std::string_view text);
inline constexpr double kLetter_px = 7.2;

}  // namespace hyrax
