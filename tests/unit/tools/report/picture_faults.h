// What a reader would stumble over in an SVG picture: texts that overlap or are cut, colours too pale to
// read.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "tools/report/look.h"
#include "tools/report/svg.h"

namespace hyrax {

struct ShownText {
  std::string text = {};
  std::string colour = {};
  Box box = {};
  bool is_turned = false;
};

inline std::vector<ShownText> texts_in(const std::string& sheet) {
  static const std::regex kText(
      "<text x=\"([-0-9.e]+)\" y=\"([-0-9.e]+)\" font-size=\"([0-9.]+)\"( text-anchor=\"(middle|end)\")?"
      "( font-weight=\"600\")? fill=\"([^\"]+)\"([^>]*)>([^<]*)</text>");
  constexpr double kNarrower = 0.95;  // Than the widest font.
  std::vector<ShownText> texts;
  for (std::sregex_iterator found(sheet.begin(), sheet.end(), kText), end; found != end; ++found) {
    const double x = std::stod((*found)[1]), y = std::stod((*found)[2]), size = std::stod((*found)[3]);
    const double width = kNarrower * text_width((*found)[9].str(), size);
    const double left = (*found)[5] == "middle" ? x - width / 2 : (*found)[5] == "end" ? x - width : x;
    texts.push_back({(*found)[9],
                     (*found)[7],
                     {left, y - 0.75 * size, left + width, y + 0.2 * size},
                     (*found)[8].str().find("rotate") != std::string::npos});
  }
  return texts;
}

/// Whether the test of the pages' modules holds the colour to the contrast that a text needs.
inline bool is_readable(const std::string& colour) {
  constexpr const char* kNames[] = {"ink",    "quiet",    "vermilion", "orange", "blue",  "green",
                                    "purple", "sky-blue", "lavender",  "good",   "bad",   "ramp-1",
                                    "ramp-2", "ramp-3",   "ramp-4",    "ramp-5", "ramp-6"};
  return std::ranges::any_of(kNames, [&](const char* name) { return colour == colour_named(name); });
}

inline void add_faults(std::vector<std::string>& faults, const std::string& sheet, const Box& whole) {
  const std::vector<ShownText> texts = texts_in(sheet);
  for (const ShownText& text : texts) {
    const Box& box = text.box;
    if (!text.is_turned && (box.left < whole.left || box.top < whole.top || box.right > whole.right ||
                            box.bottom > whole.bottom))
      faults.push_back("cut: " + text.text);
    if (!is_readable(text.colour)) faults.push_back("pale: " + text.text);
    for (const ShownText& other : texts)
      if (&text < &other && !text.is_turned && !other.is_turned && box.left < other.box.right - 0.5 &&
          other.box.left < box.right - 0.5 && box.top < other.box.bottom - 1 &&
          other.box.top < box.bottom - 1)
        faults.push_back("overlap: " + text.text + " and " + other.text);
  }
}

/// A sentence for each fault, of the picture and of those that other viewers show instead.
inline std::vector<std::string> picture_faults(std::string svg) {
  static const std::regex kSize("viewBox=\"([0-9.]+) 0 ([0-9.]+) ([0-9.]+)\"");
  std::vector<std::string> faults;
  // librsvg gives a clip the height of the picture by it, and so moves what is in the clip.
  if (std::regex_search(svg, std::regex("[>}]svg\\{")))
    faults.push_back("a rule for the picture holds for its parts");
  while (!svg.empty()) {
    const std::string sheet = svg.substr(0, svg.find("<svg class=", 1));
    svg.erase(0, sheet.size());
    std::smatch found;
    if (!std::regex_search(sheet, found, kSize)) continue;
    const double left = std::stod(found[1]);
    add_faults(faults, sheet, {left, 0.0, left + std::stod(found[2]), std::stod(found[3])});
  }
  return faults;
}

/// Pairs of series that no reader can tell apart. Faint ones have their names beside them and do not count.
inline std::vector<std::string> shared_looks(const std::vector<Series>& series) {
  std::vector<std::string> faults;
  for (const Series& one : series)
    for (const Series& other : series)
      if (&one < &other && one.look.tone != Tone::faint && !one.x.empty() && !other.x.empty() &&
          one.look.tone == other.look.tone && one.look.form == other.look.form &&
          one.look.dash == other.look.dash && one.look.marker == other.look.marker)
        faults.push_back(one.name + " looks like " + other.name);
  return faults;
}

}  // namespace hyrax
