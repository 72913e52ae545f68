#include "tools/report/figure_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hyrax {
namespace {

constexpr std::string_view kFonts = "Helvetica Neue,Helvetica,Arial,Liberation Sans,sans-serif";
constexpr double kTextSize = 14;
constexpr double kTitleSize = 22;
constexpr double kLetterWidth = 0.56;  // On average, as a part of a letter's size.

// The card: a polygon, since gnuplot's rectangles have sharp corners.
std::string card(const Canvas& canvas) {
  constexpr double kRadius = 12;
  constexpr double kEdge = 0.5;
  constexpr int kPointsPerCorner = 8;
  const std::array<std::array<double, 2>, 4> centres = {
      {{canvas.width - kEdge - kRadius, kEdge + kRadius},
       {kEdge + kRadius, kEdge + kRadius},
       {kEdge + kRadius, canvas.height - kEdge - kRadius},
       {canvas.width - kEdge - kRadius, canvas.height - kEdge - kRadius}}};
  std::string corners, first;
  for (std::size_t corner = 0; corner < centres.size(); ++corner)
    for (int i = 0; i <= kPointsPerCorner; ++i) {
      const double angle =
          std::numbers::pi / 2 * (static_cast<double>(corner) + static_cast<double>(i) / kPointsPerCorner);
      const std::string place = screen(canvas, centres[corner][0] + kRadius * std::cos(angle),
                                       centres[corner][1] - kRadius * std::sin(angle));
      if (first.empty()) first = place;
      corners += place + " to ";
    }
  return fmt::format("set object 1 polygon from {}{} behind fs solid border lc rgb '{}' fc rgb '{}' lw 1\n",
                     corners, first, style::kHairline, style::kCard);
}

std::string in_one_line(std::string_view text) {
  std::string line(text);
  for (char& letter : line)
    if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) letter = ' ';
  return line;
}

double title_size(const Canvas& canvas, std::string_view title) {
  const double room = canvas.width - 2 * style::kMargin;
  return std::floor(std::min(
      kTitleSize, room / (kLetterWidth * static_cast<double>(std::max<std::size_t>(title.size(), 1)))));
}

}  // namespace

std::string figure_head(const Canvas& canvas, std::string_view title, std::string_view subtitle,
                        std::string_view note, std::string_view note_colour) {
  std::string head = fmt::format(
      "# {} #\nset encoding utf8\nset minussign\n"
      "set terminal svg size {},{} fixed noenhanced rounded font '{},{}'\n"
      "set border 0\nset key off\nset tics scale 0.5 nomirror textcolor rgb '{}'\n",
      in_one_line(title), canvas.width, canvas.height, kFonts, kTextSize, style::kQuietInk);
  head += card(canvas);
  head += fmt::format("set label 1 {} at {} font ',{}' tc rgb '{}'\n", in_quotes(title),
                      screen(canvas, style::kMargin, 34), title_size(canvas, title), style::kInk);
  head += fmt::format("set label 2 {} at {} tc rgb '{}'\n", in_quotes(subtitle),
                      screen(canvas, style::kMargin, 58), style::kQuietInk);
  if (!note.empty())
    head += fmt::format("set label 3 {} at {} right tc rgb '{}'\n", in_quotes(note),
                        screen(canvas, canvas.width - style::kMargin, 34), note_colour);
  return head;
}

std::string viridis() {
  return "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', "
         "5 '#1f9e89', 6 '#35b779') maxcolors 40\n";
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char letter : in_one_line(text)) {
    result += letter;
    if (letter == '\'') result += '\'';
  }
  return result + "'";
}

std::string screen(const Canvas& canvas, double x, double y) {
  return fmt::format("screen {:.5f},{:.5f}", x / canvas.width, 1 - y / canvas.height);
}

std::string arrow(const Canvas& canvas, double x, double y, double dx, double dy) {
  return fmt::format("set arrow from {} to {} front filled head size screen 0.011,20,60 lw 2 lc rgb '{}'\n",
                     screen(canvas, x, y), screen(canvas, x + dx, y + dy), style::kInk);
}

}  // namespace hyrax
