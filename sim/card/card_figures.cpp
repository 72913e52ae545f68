#include "sim/card/card.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace hyrax {
namespace {

constexpr Tone kBefore = Tone::quiet;
constexpr Tone kAfter = Tone::vermilion;

// How each core is drawn, and its part of a line.
struct DrawnCore {
  const char* name;
  std::optional<Band> Bands::*band;
  Tone tone;
};
constexpr DrawnCore kCores[] = {{"base", &Bands::before, kBefore}, {"candidate", &Bands::after, kAfter}};

std::vector<LegendEntry> both_cores(Form form) {
  std::vector<LegendEntry> legend;
  for (const DrawnCore& core : kCores) legend.push_back({core.name, {.form = form, .tone = core.tone}});
  return legend;
}

// The share of a sample up to each of its values.
Series shares_up_to(const std::string& name, const std::vector<double>& values, Tone tone) {
  Series series{.name = name, .look = {.tone = tone}, .x = values};
  std::ranges::sort(series.x);
  for (std::size_t count = 1; count <= values.size(); ++count)
    series.y.push_back(100.0 * static_cast<double>(count) / static_cast<double>(values.size()));
  return series;
}

Figure landing_figure(const Card& card) {
  Plot plot{.x = {.label = "distance of the two landing places, px", .low = 0.0},
            .y = {.label = "flings up to this distance, %", .low = 0.0, .high = 100.0},
            .series = {shares_up_to("flings", card.random.distances_px, kAfter)},
            .when_empty = "no fling settles with both cores"};
  return {.suffix = "-landing",
          .title = "Where flings land",
          .subtitle = fmt::format("The same {} random flings with both cores at 60 Hz", card.flings),
          .body = std::vector{std::move(plot)}};
}

Figure display_figure(const DisplayLine& line) {
  Plot plot{.x = {.label = "spread of a fling's landing places, px", .low = 0.0},
            .y = {.label = "flings up to this spread, %", .low = 0.0, .high = 100.0},
            .series = {shares_up_to("base", line.spreads_px.before, kBefore),
                       shares_up_to("candidate", line.spreads_px.after, kAfter)},
            .when_empty = "no fling settles on every display"};
  return {.suffix = "-displays",
          .title = "The same fling on many displays",
          .subtitle = fmt::format("Largest minus smallest x where it lands at 24 to 1000 Hz, {} of {} flings",
                                  line.spreads_px.before.size(), line.flings),
          .body = std::vector{std::move(plot)},
          .legend = both_cores(Form::line)};
}

Figure exact_figure(const std::vector<Bands>& distances_px) {
  Plot plot{.x = {.label = "time since the throw, s"},
            .y = {.label = "distance from the exact motion, px", .low = 0.0}};
  for (const DrawnCore& core : kCores) {
    const Look outline{.tone = core.tone, .width_px = 1.5, .dash = Dash::short_dashes};
    Series low{.name = std::string(core.name) + ", one of ten flings is nearer", .look = outline};
    Series high{.name = std::string(core.name) + ", one of ten flings is farther", .look = outline};
    Series median{.name = std::string(core.name) + ", median",
                  .look = {.form = Form::line_and_points, .tone = core.tone}};
    for (std::size_t second = 0; second < distances_px.size(); ++second) {
      const std::optional<Band>& band = distances_px[second].*core.band;
      if (!band) continue;
      for (Series* const series : {&low, &high, &median})
        series->x.push_back(static_cast<double>(second + 1));
      low.y.push_back(band->low);
      high.y.push_back(band->high);
      median.y.push_back(band->median);
    }
    for (Series* const series : {&low, &high, &median}) plot.series.push_back(std::move(*series));
  }
  return {.suffix = "-exact",
          .title = "Distance from the exact motion",
          .subtitle = "Median and, dashed, the ends of the middle 80 % of the flings, 60 rows a second",
          .body = std::vector{std::move(plot)},
          .legend = both_cores(Form::line_and_points)};
}

Figure energy_figure(const std::array<Bands, kEnergyCauseCount>& energy_px2_per_s2) {
  Plot plot{.x = {.label = "candidate minus base, energy as px of height"},
            .y = {.categories = {"in flight, against the exact flight", "at walls, by lift", "by bounces",
                                 "by friction"}},
            .marks = {{.at = 0.0, .tone = Tone::hairline}}};
  Series series{.name = "change", .look = {.form = Form::points, .tone = kAfter, .marker_size = 0.9}};
  for (std::size_t cause = 0; cause < kEnergyCauseCount; ++cause) {
    const auto& [before, after] = energy_px2_per_s2[cause];
    if (!before || !after) continue;
    series.x.push_back((after->median - before->median) / kHeight_px2_per_s2);
    series.y.push_back(static_cast<double>(cause));
  }
  plot.series.push_back(std::move(series));
  return {.suffix = "-energy",
          .title = "Change of energy by cause",
          .subtitle = "Of a fling until it settles: difference of the medians of the flings",
          .body = std::vector{std::move(plot)}};
}

}  // namespace

std::vector<Figure> card_figures(const Card& card) {
  std::vector<Figure> figures = {landing_figure(card), display_figure(card.displays),
                                 exact_figure(card.exact_px), energy_figure(card.energy_px2_per_s2)};
  if (card.random.farthest) figures.insert(figures.begin(), *card.random.farthest);
  return figures;
}

}  // namespace hyrax
