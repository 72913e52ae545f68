#include "sim/study/rest/rest_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "sim/core/core.h"
#include "sim/study/display_rates.h"
#include "sim/study/methods/many_flings.h"

namespace hyrax {
namespace {

// Where the picture steps from the states at one rate to those at the next: at the boundary between them, or
// half way on the logarithmic axis.
double step_between(double low_hz, double high_hz, const std::vector<RestBoundary>& boundaries) {
  for (const RestBoundary& boundary : boundaries)
    if (boundary.analytic_hz > low_hz && boundary.analytic_hz < high_hz) return boundary.analytic_hz;
  return std::sqrt(low_hz * high_hz);
}

// The part of the flings that end in `state`, above those in the states after it.
Series share_series(const RestResults& results, FinalState state, Tone tone) {
  const std::vector<RateEnds>& map = results.map;
  Series series{.name = std::string(text_of(state)), .look = {.form = Form::band, .tone = tone}};
  for (std::size_t i = 0; i < map.size(); ++i) {
    double below = 0.0;
    if (state == FinalState::zero_speed) below += map[i].percent(FinalState::two_cycle);
    if (state != FinalState::residual_speed) below += map[i].percent(FinalState::residual_speed);
    const double from_hz =
        i == 0 ? map[i].rate_hz : step_between(map[i - 1].rate_hz, map[i].rate_hz, results.boundaries);
    const double to_hz = i + 1 == map.size()
                             ? map[i].rate_hz
                             : step_between(map[i].rate_hz, map[i + 1].rate_hz, results.boundaries);
    for (const double rate_hz : {from_hz, to_hz}) {
      series.x.push_back(rate_hz);
      series.y.push_back(below + map[i].percent(state));
      series.y_low.push_back(below);
    }
  }
  return series;
}

// The name of an area, in its middle where it is highest.
PointText name_in(const Series& band) {
  std::size_t first = 0, last = 0;
  const auto height = [&](std::size_t row) { return band.y[row] - band.y_low[row]; };
  for (std::size_t row = 0; row < band.x.size(); ++row) {
    if (height(row) > height(first)) first = row;
    if (height(row) >= height(first)) last = row;
  }
  if (band.x.empty() || height(first) <= 0.0) return {kNotGiven, kNotGiven};
  return {std::sqrt(band.x[first] * band.x[last]), (band.y[first] + band.y_low[first]) / 2, band.name,
          Tone::ink};
}

Figure state_figure(const RestResults& results) {
  Plot plot{.x = display_rate_axis(20, 1000),
            .y = {.label = "flings, %; dashed: analytic boundaries, Hz", .low = 0, .high = 100},
            .series = {share_series(results, FinalState::residual_speed, Tone::blue),
                       share_series(results, FinalState::two_cycle, Tone::sky_blue),
                       share_series(results, FinalState::zero_speed, Tone::hairline)}};
  for (const Series& series : plot.series) plot.texts.push_back(name_in(series));
  for (const RestBoundary& boundary : results.boundaries)
    plot.marks.push_back({.at = boundary.analytic_hz, .text = fmt::format("{:.2f}", boundary.analytic_hz)});
  Figure figure{.title = "How a fling ends on the floor",
                .subtitle = "The position stands still in all three; only vy differs, which cannot be seen",
                .legend = {{"residual speed: vy constant", plot.series[0].look},
                           {"two-cycle: vy 0 in every other row", plot.series[1].look},
                           {"zero speed: vy exactly 0", plot.series[2].look}}};
  figure.body = std::vector{std::move(plot)};
  return figure;
}

Figure time_figure(const std::vector<RateEnds>& map) {
  Series spread{.name = "eight of ten flings", .look = {.form = Form::band, .tone = Tone::hairline}};
  Series median{.name = "median", .look = {.tone = Tone::blue}};
  for (const RateEnds& ends : map) {
    if (!ends.settles_s) continue;
    for (Series* const series : {&spread, &median}) series->x.push_back(ends.rate_hz);
    spread.y.push_back(ends.settles_s->high);
    spread.y_low.push_back(ends.settles_s->low);
    median.y.push_back(ends.settles_s->median);
  }
  Figure figure{
      .suffix = "-time",
      .title = "Time to settle",
      .subtitle = fmt::format("Time until a random fling stays within half a pixel of its place; {} "
                              "flings at each rate, seed {}",
                              map.empty() ? 0 : map.front().total(), kFlingSeed),
      .legend = {{median.name, median.look}, {spread.name, spread.look}}};
  figure.body = std::vector{Plot{.x = display_rate_axis(20, 1000),
                                 .y = {.label = "time, s", .low = 0},
                                 .series = {std::move(spread), std::move(median)}}};
  return figure;
}

Figure bounce_figure(const Core& core, std::vector<DropBounce> bounces) {
  constexpr std::array<Tone, 7> kTones = {Tone::vermilion, Tone::orange, Tone::blue, Tone::purple,
                                          Tone::sky_blue,  Tone::green,  Tone::ink};
  std::ranges::sort(bounces, {}, &DropBounce::phase);
  std::map<double, Series> rates;
  for (const DropBounce& bounce : bounces) {
    rates[bounce.rate_hz].x.push_back(bounce.phase);
    rates[bounce.rate_hz].y.push_back(bounce.restitution);
  }
  Plot plot{.x = {.label = "part of the contact's step below the floor", .low = 0, .high = 1},
            .y = {.label = "effective restitution; dashed: that of the core", .decimals = 3},
            .marks = {{.is_vertical = false, .at = core.constants->restitution}}};
  Figure figure{.suffix = "-restitution",
                .title = "Effective restitution",
                .subtitle = "Speed after the first bounce of a drop over the speed of the exact impact"};
  for (auto& [rate_hz, series] : rates) {
    series.name = fmt::format("{:.0f} Hz", rate_hz);
    series.look = {.tone = kTones[plot.series.size() % kTones.size()]};
    figure.legend.push_back({series.name, series.look});
    plot.series.push_back(std::move(series));
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

}  // namespace

std::vector<Figure> rest_figures(const Core& core, const RestResults& results) {
  return {state_figure(results), time_figure(results.map), bounce_figure(core, results.bounces)};
}

}  // namespace hyrax
