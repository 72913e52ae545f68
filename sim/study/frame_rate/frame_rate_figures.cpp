#include "sim/study/frame_rate/frame_rate.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "sim/study/frame_rate/ladder_result.h"

namespace hyrax {
namespace {

constexpr std::array<Tone, 2> kMethodTones = {Tone::vermilion, Tone::blue};

// As far as the study has rates, and some space.
Axis rate_axis(const FrameRateStudy& study) {
  const auto [low, high] = std::ranges::minmax_element(study.shifts, {}, &DisplayShift::rate_hz);
  return display_rate_axis(low->rate_hz / 1.1, high->rate_hz * 1.1);
}

Figure landing_figure(const FrameRateStudy& study) {
  Plot plot{.x = rate_axis(study), .y = {.label = "x where it settles, px"}};
  Figure figure{.subtitle =
                    fmt::format("Where it settles; frame-rate independence of {} flings {:.0f} by the "
                                "paper's step, {:.0f} by time (100: the same place at every rate)",
                                study.scores[0].spreads_px.samples, study.scores[0].score,
                                study.scores[kDisplayClockNames.size()].score)};
  constexpr std::array<Look, kDisplayClockNames.size()> kLooks = {
      Look{.form = Form::line_and_points},
      Look{.form = Form::points, .marker = Marker::ring, .marker_size = 0.9},
      Look{.form = Form::points, .marker = Marker::square, .marker_size = 0.9}};
  for (std::size_t method = 0; method < kFrameRateMethods.size(); ++method) {
    for (std::size_t clock = 0; clock < kDisplayClockNames.size(); ++clock) {
      Series series{.name = fmt::format("{}, {} frames", kMethodTexts[method], kDisplayClockNames[clock]),
                    .look = kLooks[clock]};
      series.look.tone = kMethodTones[method];
      for (const Landing& landing : drawn_landings(study, method, static_cast<DisplayClock>(clock))) {
        series.x.push_back(landing.rate_hz);
        series.y.push_back(landing.end.x_px);
      }
      plot.series.push_back(std::move(series));
    }
    figure.legend.push_back({std::string(kMethodTexts[method]), {.tone = kMethodTones[method]}});
  }
  for (std::size_t clock = 1; clock < kDisplayClockNames.size(); ++clock) {
    figure.legend.push_back({std::string(kClockTexts[clock]), kLooks[clock]});
    figure.legend.back().look.tone = Tone::quiet;
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

// Over all flings, not the drawn one alone.
Figure shift_figure(const FrameRateStudy& study) {
  Plot plot{.x = rate_axis(study), .y = {.label = "distance from where it settles at 60 Hz, px", .low = 0}};
  constexpr std::array<Tone, kFrameRateMethods.size()> kBandTones = {Tone::bad, Tone::sky_blue};
  Figure figure{
      .suffix = "-flings",
      .title = "Many flings, many displays",
      .subtitle = fmt::format("{} flings (seed {}), every frame the same; line: median, band: 10 to 90 %",
                              study.steadier_by_time[0].of, kFlingSeed)};
  for (std::size_t method = 0; method < kFrameRateMethods.size(); ++method) {
    Series band{.name = fmt::format("{}, 10 to 90 %", kMethodTexts[method]),
                .look = {.form = Form::band, .tone = kBandTones[method]}};
    Series median{.name = std::string(kMethodTexts[method]), .look = {.tone = kMethodTones[method]}};
    for (const DisplayShift& shift : study.shifts) {
      if (shift.method != method || shift.clock != DisplayClock::steady) continue;
      for (Series* const series : {&band, &median}) series->x.push_back(shift.rate_hz);
      band.y.push_back(shift.shift_px.high);
      band.y_low.push_back(shift.shift_px.low);
      median.y.push_back(shift.shift_px.median);
    }
    figure.legend.push_back({median.name, median.look});
    figure.legend.push_back({band.name, band.look});
    plot.series.insert(plot.series.begin() + static_cast<std::ptrdiff_t>(method), std::move(band));
    plot.series.push_back(std::move(median));
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

Figure fan_figure(const FrameRateStudy& study, std::size_t method) {
  constexpr double kHalf_px = 64.0;  // Of the sprite in kDesktop.
  Plot plot{.x = {.label = "x of the centre, px", .low = 0, .high = kDesktop.right_px + 2 * kHalf_px},
            .y = {.label = "y of the centre, px, downwards",
                  .is_reversed = true,
                  .low = 0,
                  .high = kDesktop.bottom_px + 2 * kHalf_px},
            .has_equal_scales = true};
  Figure figure{.suffix = method == 0 ? "-fan" : "-fan-by-time",
                .title = method == 0 ? "The fan of one fling" : "The same fling, drag and friction by time"};
  std::map<double, Series> paths;
  for (const FanPoint& point : study.paths) {
    if (point.method != method) continue;
    paths[point.rate_hz].x.push_back(point.x_px + kHalf_px);
    paths[point.rate_hz].y.push_back(point.y_px + kHalf_px);
  }
  figure.subtitle =
      fmt::format("The path of its centre, {}, at {} display rates", kMethodTexts[method], paths.size());
  for (auto& [rate_hz, series] : paths) {
    series.name = fmt::format("{:.0f} Hz", rate_hz);
    series.look = {.tone = ramp_tone(plot.series.size(), paths.size()), .width_px = 2};
    plot.texts.push_back({series.x.back(), series.y.back(), series.name, series.look.tone});
    plot.series.push_back(std::move(series));
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

}  // namespace

std::vector<Figure> frame_rate_figures(const FrameRateStudy& study) {
  return {landing_figure(study), shift_figure(study), fan_figure(study, 0), fan_figure(study, 1)};
}

}  // namespace hyrax
