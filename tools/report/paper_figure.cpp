#include "tools/report/paper_figure.h"

#include <array>

#include <fmt/format.h>

#include "tools/report/figure_style.h"

namespace hyrax {
namespace {

constexpr double kLineHeight = 38;  // All in px of the SVG.
constexpr double kTop = 84;
constexpr double kSection = style::kMargin;
constexpr double kSentence = 80;
constexpr double kVerdict = 730;
constexpr double kVerdictWidth = 112;
constexpr double kNumber = 960;           // Right edge.
constexpr std::size_t kSentenceMax = 98;  // Letters that fit.
constexpr std::size_t kMeasuredMax = 122;

// Pale, for ink to stand on: holds, holds when, does not hold, not measured.
constexpr std::array<std::string_view, 4> kFills = {"#cfe8df", "#f6dfa9", "#f1b594", "#d0d7de"};

std::string shortened(const std::string& text, std::size_t letters_max) {
  if (text.size() <= letters_max) return text;
  return text.substr(0, text.rfind(' ', letters_max - 2)) + " …";
}

}  // namespace

std::string paper_figure_script(const std::vector<Claim>& claims) {
  const Canvas canvas{kNumber + style::kMargin, kTop + kLineHeight * static_cast<double>(claims.size()) + 20};
  std::string script =
      figure_head(canvas, "The paper's claims, measured",
                  "each sentence against the core: section, words, verdict, what was measured");
  script += "unset xtics\nunset ytics\nset lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n";
  const auto label = [&](const std::string& words, double x, double y, std::string_view side, int size,
                         std::string_view colour) {
    script += fmt::format("set label {} at {} {} front font ',{}' tc rgb '{}'\n", quoted(words),
                          screen(canvas, x, y), side, size, colour);
  };
  for (std::size_t row = 0; row < claims.size(); ++row) {
    const Claim& claim = claims[row];
    const double y = kTop + kLineHeight * (static_cast<double>(row) + 0.4);
    script += fmt::format("set object {} rectangle from {} to {} fs solid 1 noborder fc rgb '{}'\n", 10 + row,
                          screen(canvas, kVerdict, y - 9), screen(canvas, kVerdict + kVerdictWidth, y + 9),
                          kFills[static_cast<std::size_t>(claim.verdict)]);
    label(claim.section(), kSection, y, "left", 12, style::kQuietInk);
    label(shortened(claim.sentence, kSentenceMax), kSentence, y, "left", 13, style::kInk);
    // When it holds is worth more than how that was seen.
    const bool has_condition = claim.verdict == ClaimVerdict::holds_when && !claim.remark.empty();
    label(shortened(has_condition ? claim.remark : claim.measured, kMeasuredMax), kSentence, y + 16, "left",
          10, style::kQuietInk);
    label(std::string(name_of(claim.verdict)) + (has_condition ? " …" : ""), kVerdict + kVerdictWidth / 2, y,
          "center", 12, style::kInk);
    label(fmt::format("{:.4g}{}", claim.number, claim.unit == "1" ? "" : " " + claim.unit), kNumber, y,
          "right", 12, style::kInk);
  }
  return script + "set xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n";
}

}  // namespace hyrax
