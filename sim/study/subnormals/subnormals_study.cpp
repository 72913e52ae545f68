// `hyrax-sim study subnormals`: tables, figure, verdict.
#include <cmath>

#include <fmt/format.h>

#include "sim/study/study.h"
#include "sim/study/subnormals/subnormals.h"

namespace hyrax {
namespace {

constexpr double kRates_hz[] = {24.0, 30.0, 60.0, 120.0, 144.0, 240.0, 1000.0};

double seconds_of(std::int64_t step, double rate_hz) {
  return step < 0 ? kNotGiven : static_cast<double>(step) / rate_hz;
}

Table end_table(const std::vector<SlideEnd>& ends) {
  return {
      "ends",
      "where vx of a fling ends",
      {column_of<double>("rate", "Hz", "frame rate", ends, &SlideEnd::rate_hz),
       column_of<std::int64_t>("subnormal_from_row", "", "first row with a subnormal vx; -1: none", ends,
                               &SlideEnd::subnormal_step),
       column_of<double>("subnormal_after", "s", "its time", ends,
                         [](const SlideEnd& end) { return seconds_of(end.subnormal_step, end.rate_hz); }),
       column_of<std::int64_t>("stuck_from_row", "", "first row whose vx never changes again; -1: none", ends,
                               &SlideEnd::stuck_step),
       column_of<double>("stuck_after", "s", "its time", ends,
                         [](const SlideEnd& end) { return seconds_of(end.stuck_step, end.rate_hz); }),
       column_of<double>("stuck_vx", "px/s", "that speed", ends, &SlideEnd::stuck_vx_px_per_s),
       column_of<double>("moves", "px", "way from the first subnormal row on", ends, &SlideEnd::moved_px)}};
}

// A fixed number of digits would print hundreds of zeros.
Table shown_ends(const std::vector<SlideEnd>& ends) {
  Table table = end_table(ends);
  for (Column& column : table.columns)
    if (column.name == "stuck_vx")
      column = column_of<std::string>("stuck_at", "px/s", "", ends, [](const SlideEnd& end) {
        return fmt::format("{:.4g}", end.stuck_vx_px_per_s);
      });
  return table;
}

Table cost_table(const std::vector<SlideCost>& costs) {
  const auto number = [&costs](const char* name, const char* unit, const char* long_name,
                               MedianEstimate SlideCost::*estimate, double MedianEstimate::*part) {
    return column_of<double>(
        name, unit, long_name, costs, [=](const SlideCost& cost) { return cost.*estimate.*part; }, 3);
  };
  return {
      "costs",
      "cost of a step on the floor",
      {column_of<std::string>("of", "", "what was timed", costs, &SlideCost::what),
       column_of<std::string>("with", "", "horizontal speed", costs, &SlideCost::with),
       number("cost", "ns", "of a step, median", &SlideCost::step_ns, &MedianEstimate::median),
       number("cost_low", "ns", "95 % interval of the median", &SlideCost::step_ns, &MedianEstimate::low),
       number("cost_high", "ns", "95 % interval of the median", &SlideCost::step_ns, &MedianEstimate::high),
       number("ratio", "1", "to the same with vx = 0, median", &SlideCost::ratio, &MedianEstimate::median),
       number("ratio_low", "1", "95 % interval of the median", &SlideCost::ratio, &MedianEstimate::low),
       number("ratio_high", "1", "95 % interval of the median", &SlideCost::ratio, &MedianEstimate::high)}};
}

Figure speed_figure(const std::vector<SlideEnd>& ends) {
  constexpr Tone kTones[] = {Tone::vermilion, Tone::blue, Tone::green};
  Plot plot{.x = {.label = "time, s", .low = 0},
            .y = {.label = "log10 of |vx|, px/s", .low = -330, .high = 10},
            .marks = {{.is_vertical = false, .at = -307.65, .text = "subnormal below"}}};
  Figure figure{
      .title = "vx of a fling on the floor",
      .subtitle = "It shrinks to 0.7992 of itself a step until it is stuck at two units of the last place"};
  for (const SlideEnd& end : ends) {
    if (end.rate_hz != 30.0 && end.rate_hz != 60.0 && end.rate_hz != 240.0) continue;
    Series series{.name = fmt::format("{:.0f} Hz", end.rate_hz),
                  .look = {.tone = kTones[plot.series.size()]}};
    series.x = end.t_s;
    series.y = end.exponent;
    figure.legend.push_back({series.name, series.look});
    plot.series.push_back(std::move(series));
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

StudyResult run_subnormals(const StudyRequest& request) {
  std::vector<SlideEnd> ends;
  for (const double rate_hz : kRates_hz) ends.push_back(slide_end(rate_hz));
  const SlideCosts costs = measure_slide_costs(request.now_ns, request.is_quick);
  const double expected_vx = largest_stuck_vx_px_per_s();
  StudyResult result{.tables = {end_table(ends), cost_table(costs.costs)},
                     .figures = {speed_figure(ends)},
                     .summary = {end_table(ends), cost_table(costs.costs)}};
  result.verdict.text = {
      fmt::format("subnormals: vx of a fling never becomes 0; it is stuck at {:.4g} px/s or less",
                  expected_vx),
      shown_ends(ends)};
  if (costs.probe.is_steady()) {
    result.verdict.text.emplace_back(
        fmt::format("Cost of a step on the floor, timed in random order on {}:", request.machine));
    result.verdict.text.emplace_back(cost_table(costs.costs));
  } else {
    result.verdict.text.emplace_back("Cost of a step on the floor: " + unsteady_text(costs.probe) + ".");
  }
  for (const SlideEnd& end : ends) {
    if (end.stuck_step < 0 || end.subnormal_step < 0 || end.stuck_vx_px_per_s == 0.0 ||
        std::fabs(end.stuck_vx_px_per_s) > expected_vx)
      result.verdict.broken.push_back(
          fmt::format("{:g} Hz: vx ends at {:.4g} px/s, not at most {:.4g} and not 0", end.rate_hz,
                      end.stuck_vx_px_per_s, expected_vx));
    if (end.moved_px != 0.0)
      result.verdict.broken.push_back(
          fmt::format("{:g} Hz: a subnormal vx moves the sprite by {:.4g} px", end.rate_hz, end.moved_px));
  }
  return result;
}

}  // namespace

Study subnormals_study() {
  return {.name = "subnormals",
          .summary = "where vx becomes subnormal on the floor, and what a step costs then",
          .run = run_subnormals};
}

}  // namespace hyrax
