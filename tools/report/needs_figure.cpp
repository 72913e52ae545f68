#include "tools/report/needs_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "sim/study/needs/needs_tables.h"
#include "tools/report/figure_style.h"
#include "tools/report/plot_frame.h"

namespace hyrax {
namespace {

constexpr double kLineHeight = 26;
constexpr std::size_t kPartsDrawnMax = 40;

std::string_view colour_of(Need need) {
  switch (need) {
    case Need::needed:
    case Need::needed_jointly:
      return style::kBlue;
    case Need::below:
      return style::kOrange;
    case Need::not_exercised:
      return style::kHairline;
  }
  return style::kInk;
}

// A square in the colour and what it means, side by side.
std::string key(const Canvas& canvas, double y) {
  constexpr std::array<Need, 3> kNeeds = {Need::needed, Need::below, Need::not_exercised};
  constexpr std::array<std::string_view, 3> kWords = {"needed", "changes something, below the tolerance",
                                                      "not exercised: not one bit changes"};
  constexpr std::array<double, 3> kAt = {0, 100, 400};
  std::string script;
  for (std::size_t i = 0; i < kNeeds.size(); ++i) {
    const double x = style::kMargin + kAt[i];
    script += fmt::format("set label '' at {} point pt 5 ps 1.1 lc rgb '{}'\n", screen(canvas, x + 6, y),
                          colour_of(kNeeds[i]));
    script += fmt::format("set label {} at {} left tc rgb '{}'\n", quoted(kWords[i]),
                          screen(canvas, x + 20, y), style::kQuietInk);
  }
  return script;
}

std::string margins(const Canvas& canvas, double left, double right, double top, double bottom) {
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
      "set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n",
      left / canvas.width, right / canvas.width, 1 - top / canvas.height, 1 - bottom / canvas.height);
}

std::string length_text(double length_px) {
  if (!std::isfinite(length_px)) return "without bound";
  return length_px >= 1000.0 ? fmt::format("{:.0f} px", length_px) : fmt::format("{:.3g} px", length_px);
}

}  // namespace

std::string needs_script(const SceneNeeds& scene, double within_px) {
  const std::size_t count = std::min(scene.parts.size(), kPartsDrawnMax);
  const Canvas canvas{960, 190 + kLineHeight * static_cast<double>(count)};
  constexpr double kTop = 118;
  const double bottom = canvas.height - 60;
  std::string script = figure_head(
      canvas, "What " + scene.scenario + " needs",
      fmt::format("How far its path moves when a part is left out; tolerance {:g} px", within_px),
      count < scene.parts.size() ? fmt::format("the first {} of {} parts", count, scene.parts.size()) : "");
  script += key(canvas, 86);
  double low = within_px > 0.0 ? within_px / 10.0 : 1e-3;
  double high = std::max(100.0, 10.0 * within_px);
  for (const PartNeed& part : scene.parts) {
    const double path_px = part.difference.path_px;
    if (path_px > 0.0) low = std::min(low, path_px / 2.0);
    if (std::isfinite(path_px)) high = std::max(high, path_px);
  }
  // What is far below the tolerance need not be told apart.
  low = within_px > 0.0 ? std::max(low, within_px * 1e-4) : std::max(low, 1e-15);
  const double longest = high;
  high *= std::pow(high / low, 0.4);  // Room for the words behind the longest bar.
  script += margins(canvas, 190, canvas.width - 28, kTop, bottom);
  script += fmt::format(
      "set object 2 rectangle from graph 0,0 to graph 1,1 behind fs solid 1 noborder fc rgb '{}'\n",
      style::kPaper);
  script += fmt::format("set yrange [{}:-0.5]\nset ytics scale 0 (", static_cast<double>(count) - 0.5);
  for (std::size_t i = 0; i < count; ++i)
    script += fmt::format("{}{} {}", i == 0 ? "" : ", ", quoted(scene.parts[i].part), i);
  script += ")\n";
  std::string tics;
  const int low_exponent = static_cast<int>(std::ceil(std::log10(low)));
  const int high_exponent = static_cast<int>(std::floor(std::log10(high)));
  const int every = std::max(1, (high_exponent - low_exponent) / 8);
  for (int exponent = low_exponent; exponent <= high_exponent; exponent += every)
    tics += fmt::format("{}'{}' 1e{}", tics.empty() ? "" : ", ", power_of_ten(exponent), exponent);
  script += fmt::format("set logscale x\nset xrange [{:.6g}:{:.6g}]\nset xtics out font ',12' ({})\n", low,
                        high, tics);
  script += fmt::format("set grid xtics back lt 1 lw 1 lc rgb '{}'\n", style::kHairline);
  script +=
      fmt::format("set label 11 'largest distance of two rows, px' at {} right font ',12' tc rgb '{}'\n",
                  screen(canvas, canvas.width - 28, canvas.height - 20), style::kQuietInk);
  for (std::size_t i = 0; i < count; ++i) {
    const PartNeed& part = scene.parts[i];
    const auto y = static_cast<double>(i);
    const double path_px = std::isfinite(part.difference.path_px) ? part.difference.path_px : longest;
    const double end = std::max(path_px, low);
    if (part.need != Need::not_exercised)
      script += fmt::format(
          "set object {} rectangle from first {:.6g}, first {} to first {:.6g}, first {} front fs solid 1 "
          "noborder "
          "fc rgb '{}'\n",
          20 + i, low, y - 0.32, end, y + 0.32, colour_of(part.need));
    std::string words = "not exercised";
    if (part.need != Need::not_exercised) {
      words = path_px == 0.0 ? "only the speed changes" : length_text(part.difference.path_px);
      if (part.difference.contacts_moved > 0)
        words += fmt::format(", {} contact{} moved", part.difference.contacts_moved,
                             part.difference.contacts_moved == 1 ? "" : "s");
      if (part.need == Need::needed_jointly) words += ", needed with others left out";
    }
    script +=
        fmt::format("set label {} at first {:.6g}, first {} left offset 0.7,0 front font ',12' tc rgb '{}'\n",
                    quoted(words), end, y, part.need == Need::not_exercised ? style::kQuietInk : style::kInk);
  }
  if (within_px > 0.0)
    script += fmt::format(
        "set arrow from first {0:.6g}, graph 0 to first {0:.6g}, graph 1 nohead front lw 1.5 dt (5,4) lc rgb "
        "'{1}'\n",
        within_px, style::kVermilion);
  return script + "plot NaN notitle\n";
}

std::string coverage_script(const std::vector<SceneNeeds>& scenes, double within_px) {
  constexpr double kRow = 17;
  constexpr double kTop = 180;
  constexpr double kLeft = 240;
  const std::vector<std::string>& columns = coverage_columns();
  const Canvas canvas{960, kTop + kRow * static_cast<double>(scenes.size()) + 30};
  std::string script =
      figure_head(canvas, "What the scenarios exercise",
                  fmt::format("Each part of model and scene left out in turn; tolerance {:g} px", within_px));
  script += key(canvas, 86);
  script += margins(canvas, kLeft, canvas.width - 28, kTop, canvas.height - 30);
  script +=
      fmt::format("set xrange [-0.5:{}]\nset yrange [{}:-0.5]\nunset xtics\nset ytics scale 0 font ',11' (",
                  static_cast<double>(columns.size()) - 0.5, static_cast<double>(scenes.size()) - 0.5);
  for (std::size_t row = 0; row < scenes.size(); ++row)
    script += fmt::format("{}{} {}", row == 0 ? "" : ", ", quoted(scenes[row].scenario), row);
  script += ")\n";
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const bool is_exercised = std::any_of(scenes.begin(), scenes.end(), [column](const SceneNeeds& scene) {
      return coverage_of(scene)[column] != Need::not_exercised;
    });
    script += fmt::format(
        "set label {} at first {}, graph 1 left offset 0,0.6 rotate by 55 font ',12' tc rgb '{}'\n",
        quoted(columns[column] + (is_exercised ? "" : " (never)")), column,
        is_exercised ? style::kQuietInk : style::kVermilion);
  }
  int object = 20;
  for (std::size_t row = 0; row < scenes.size(); ++row) {
    const std::vector<Need> coverage = coverage_of(scenes[row]);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const auto x = static_cast<double>(column);
      const auto y = static_cast<double>(row);
      script += fmt::format(
          "set object {} rectangle from first {}, first {} to first {}, first {} front fs solid 1 noborder "
          "fc rgb '{}'\n",
          object++, x - 0.44, y - 0.42, x + 0.44, y + 0.42, colour_of(coverage[column]));
    }
  }
  return script + "plot NaN notitle\n";
}

}  // namespace hyrax
