#include "tools/report/look.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "look_css.h"

namespace hyrax {
namespace {

constexpr int kSpeedColours = 24;

using ValuesByName = std::map<std::string, std::string, std::less<>>;

// The lines "--NAME: VALUE;" of a part of the list.
ValuesByName values_in(std::string_view css) {
  ValuesByName values;
  for (std::size_t at = css.find("--"); at != css.npos; at = css.find("--", at + 2)) {
    const std::size_t colon = css.find(':', at), end = css.find(';', at);
    values.emplace(css.substr(at + 2, colon - at - 2), css.substr(colon + 2, end - colon - 2));
  }
  return values;
}

constexpr std::string_view kCss = kLookCss;

const ValuesByName& light() {
  static const ValuesByName values = values_in(kCss.substr(0, kCss.find("@media")));
  return values;
}

std::string speed_colour(int step, double from, double to) {
  constexpr std::array kViridis = {0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                   0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};
  const double place = from + (to - from) * step / (kSpeedColours - 1);
  const auto before = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  std::string colour = "#";
  for (const int shift : {16, 8, 0}) {
    const auto channel = [&](std::size_t stop) {
      return static_cast<double>(kViridis[stop] >> shift & 0xff);
    };
    colour += fmt::format("{:02x}", std::lround(std::lerp(channel(before), channel(before + 1),
                                                          place - static_cast<double>(before))));
  }
  return colour;
}

}  // namespace

const std::string& colour_named(std::string_view name) {
  const auto found = light().find(name);
  assert(found != light().end());
  return found->second;
}

const std::vector<std::pair<std::string, std::string>>& light_and_dark() {
  static const auto colours = [] {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& [name, colour] : values_in(kCss.substr(kCss.find("@media"))))
      pairs.emplace_back(colour_named(name), colour);
    for (int step = 0; step < kSpeedColours; ++step)
      pairs.emplace_back(speed_colour(step, 0.0, 6.0), speed_colour(step, 3.0, 9.0));
    return pairs;
  }();
  return colours;
}

const std::string& speed_colour(double part) {
  const auto step = static_cast<std::size_t>(std::lround((kSpeedColours - 1) * std::clamp(part, 0.0, 1.0)));
  return light_and_dark()[light_and_dark().size() - kSpeedColours + step].first;
}

const std::string& colour_of(Tone tone) {
  const bool is_fill = tone == Tone::good || tone == Tone::notable || tone == Tone::bad;
  std::string name = (is_fill ? "fill-" : "") + std::string(kToneNames.at(static_cast<std::size_t>(tone)));
  std::replace(name.begin(), name.end(), '_', '-');
  return colour_named(name);
}

const std::string& dashes_of(Dash dash) {
  static const std::string solid;
  if (dash == Dash::solid) return solid;
  return colour_named(dash == Dash::short_dashes  ? "short-dashes"
                      : dash == Dash::long_dashes ? "long-dashes"
                                                  : "dots");
}

double text_width(std::string_view text, double size_px) {
  // Of the letters from the blank to the tilde, in thousandths of their size.
  constexpr std::array<int, 95> kWidths = {
      278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
      556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
      611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
      667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
      222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
  constexpr int kOther = 556;
  int thousandths = 0;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte >= 0x20 && byte < 0x7f) thousandths += kWidths[byte - 0x20];
    if (byte >= 0xc0) thousandths += kOther;  // The first byte of a letter.
  }
  constexpr double kWidest = 1.12;  // Of the fonts that may take Arial's place.
  return kWidest * thousandths * size_px / 1000.0;
}

std::string power_of_ten(int exponent) {
  constexpr std::array<std::string_view, 10> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kRaised[static_cast<std::size_t>(digit - '0')];
  return text;
}

}  // namespace hyrax
