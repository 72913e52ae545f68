// What gnuplot's SVG lacks: titles for people and a dark mode.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

/// `svg`, drawn by gnuplot from `script` on a light card, with
/// - the title in the script's first line "# TITLE #" as its `<title>`;
/// - the titles in its plot commands as those of the curves: without enhanced text, gnuplot writes none;
/// - a dark mode: where the reader prefers dark colours, a filter inverts the lightness and keeps the hues,
///   so that every contrast of the light picture remains.
[[nodiscard]] std::string finished_svg(std::string svg, std::string_view script);

}  // namespace hyrax
