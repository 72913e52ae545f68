// The look that all pictures share: the colours and dashes of page/look.css, light and dark, and text's
// width.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/result/figure.h"

namespace hyrax {

/// The colour `--NAME` of page/look.css in light pictures, "#0072b2". REQUIRES: the list has it.
[[nodiscard]] const std::string& colour_named(std::string_view name);
[[nodiscard]] const std::string& colour_of(Tone tone);

/// Speeds as colours, `part` from 0 to 1: viridis (van der Walt and Smith, 2015), without its palest part,
/// which would be lost on paper; in dark pictures without its darkest.
[[nodiscard]] const std::string& speed_colour(double part);

/// All colours, each with the one that takes its place in dark pictures.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& light_and_dark();

/// Of a line, as SVG's stroke-dasharray; empty: solid.
[[nodiscard]] const std::string& dashes_of(Dash dash);

/// Names of tones, as page/look.css and the pages' data have them.
inline constexpr std::array<std::string_view, 22> kToneNames = {
    "ink",    "quiet",    "faint",    "hairline", "vermilion", "orange", "blue",  "green",
    "purple", "sky_blue", "lavender", "good",     "notable",   "bad",    "shade", "none",
    "ramp_1", "ramp_2",   "ramp_3",   "ramp_4",   "ramp_5",    "ramp_6"};

/// The width of UTF-8 text of that size in px, in Arial's letters or in a wider font that takes its place.
[[nodiscard]] double text_width(std::string_view text, double size_px);

/// A power of ten as people write it, "10⁻¹²".
[[nodiscard]] std::string power_of_ten(int exponent);

}  // namespace hyrax
