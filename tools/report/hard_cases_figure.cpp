#include "tools/report/hard_cases_figure.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/report/figure_style.h"

namespace hyrax {
namespace {

constexpr double kRowHeight = 21;  // All in px of the SVG.
constexpr double kColumnWidth = 50;
constexpr double kLeft = 270;
constexpr double kTop = 190;
constexpr double kBelow = 56;

constexpr std::string_view kHeldFill = "#cfe8df";  // A pale green, for ink to stand on.
constexpr std::string_view kFindingFill = "#f6dfa9";
constexpr std::string_view kBrokenFill = "#f1b594";

std::vector<std::string> origins_of(const std::vector<PlayedCase>& cases) {
  std::vector<std::string> origins;
  for (const PlayedCase& played : cases)
    if (std::find(origins.begin(), origins.end(), played.hard_case.made_from) == origins.end())
      origins.push_back(played.hard_case.made_from);
  return origins;
}

class Matrix {
 public:
  Matrix(const std::vector<PlayedCase>& cases, std::vector<std::string> origins)
      : cases_(cases), origins_(std::move(origins)) {
    canvas_ = {kLeft + kColumnWidth * static_cast<double>(kInvariantCount) + 2 * style::kMargin,
               kTop + kRowHeight * static_cast<double>(origins_.size()) + kBelow};
  }

  [[nodiscard]] std::string script() {
    std::int64_t steps = 0;
    for (const PlayedCase& played : cases_) steps += played.result.steps;
    text_ = figure_head(
        canvas_, fmt::format("{} hard cases", cases_.size()),
        fmt::format("What must hold in every one of {} steps; numbers: cases with that verdict", steps));
    text_ += "unset xtics\nunset ytics\nset lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n";
    for (std::size_t column = 0; column < kInvariantCount; ++column)
      text_ += fmt::format("set label {} at {} left rotate by 50 tc rgb '{}'\n",
                           quoted(kInvariantTexts[column].name),
                           screen(canvas_, x_of(column) + kColumnWidth / 2 - 4, kTop - 10), style::kInk);
    for (std::size_t row = 0; row < origins_.size(); ++row) add_row(row);
    const double y = canvas_.height - 26;
    double x = style::kMargin;
    for (const auto& [fill, words] :
         {std::pair{kHeldFill, "held"}, std::pair{kFindingFill, "known not to hold: a finding"},
          std::pair{kBrokenFill, "broken"}}) {
      add_box(x, y - 8, 20, 16, fill);
      text_ += fmt::format("set label {} at {} left font ',12' tc rgb '{}'\n", quoted(words),
                           screen(canvas_, x + 28, y), style::kQuietInk);
      x += 56 + 6.6 * static_cast<double>(std::string_view(words).size());
    }
    return text_ + "set xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n";
  }

 private:
  static double x_of(std::size_t column) { return kLeft + kColumnWidth * static_cast<double>(column); }

  void add_row(std::size_t row) {
    const double y = kTop + kRowHeight * static_cast<double>(row);
    std::int64_t members = 0;
    for (const PlayedCase& played : cases_) members += played.hard_case.made_from == origins_[row] ? 1 : 0;
    const std::string label = members > 1 ? fmt::format("{} ×{}", origins_[row], members) : origins_[row];
    text_ += fmt::format("set label {} at {} right font ',12' tc rgb '{}'\n", quoted(label),
                         screen(canvas_, kLeft - 10, y + kRowHeight / 2), style::kInk);
    for (std::size_t column = 0; column < kInvariantCount; ++column) {
      const InvariantSummary summary = summarise(cases_, static_cast<Invariant>(column), origins_[row]);
      if (summary.asked == 0) continue;
      add_cell(x_of(column) + 1, y, summary);
    }
  }

  // A part in its own colour for each verdict, with the number of cases that have it.
  void add_cell(double x, double y, const InvariantSummary& summary) {
    const std::array<std::pair<std::int64_t, std::string_view>, 3> verdicts = {
        {{summary.held, kHeldFill}, {summary.findings, kFindingFill}, {summary.broken, kBrokenFill}}};
    const auto parts = std::count_if(verdicts.begin(), verdicts.end(),
                                     [](const auto& verdict) { return verdict.first > 0; });
    const double width = (kColumnWidth - 2) / static_cast<double>(parts);
    for (const auto& [cases, fill] : verdicts) {
      if (cases == 0) continue;
      add_box(x, y + 1, width, kRowHeight - 2, fill);
      text_ += fmt::format("set label '{}' at {} center front font ',12' tc rgb '{}'\n", cases,
                           screen(canvas_, x + width / 2, y + kRowHeight / 2), style::kInk);
      x += width;
    }
  }

  void add_box(double x, double y, double width, double height, std::string_view fill) {
    text_ += fmt::format("set object {} rectangle from {} to {} fs solid 1 noborder fc rgb '{}'\n",
                         next_object_++, screen(canvas_, x, y), screen(canvas_, x + width, y + height), fill);
  }

  const std::vector<PlayedCase>& cases_;
  std::vector<std::string> origins_;
  Canvas canvas_;
  std::string text_;
  int next_object_ = 10;
};

}  // namespace

std::string hard_cases_figure_script(const std::vector<PlayedCase>& cases) {
  return Matrix(cases, origins_of(cases)).script();
}

}  // namespace hyrax
