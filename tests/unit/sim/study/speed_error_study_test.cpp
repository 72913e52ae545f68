// The figures of the study speed-error where something was not measured or is no error at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/core/shipped_core.h"
#include "sim/study/speed_error/speed_error.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

// One flight, two methods at three rates each.
SpeedError some_study() {
  SpeedError study;
  study.problems = {study_problems().front()};
  const std::vector<MethodKind> methods = frame_methods(shipped_core());
  study.methods = {methods[0], methods[4]};
  for (std::size_t method = 0; method < 2; ++method)
    for (const double rate_hz : {30.0, 60.0, 240.0}) {
      WorkPoint point{0, method, rate_hz, {}, {}};
      point.errors.position_px = method == 0 ? rate_hz : 1.0 / rate_hz;
      point.cost = cost_of({9.0 * rate_hz, 10.0 * rate_hz, 12.0 * rate_hz});
      study.points.push_back(point);
    }
  study.orders = {{0, 0, 3, 30.0, 240.0, {.order = -1.0, .standard_error = 0.04}},
                  {0, 1, 3, 30.0, 240.0, {.order = 1.0, .standard_error = 0.0}}};
  study.paper = {{.rate_hz = 60.0, .model_px = 9.8}, {.rate_hz = 240.0, .model_px = 42.0}};
  study.repetitions = 20;
  return study;
}

std::vector<Plot> plots_of(const SpeedError& study, std::size_t problem = 0) {
  return std::get<std::vector<Plot>>(speed_error_figure(study, problem, "some machine").body);
}

const Series& series_named(const Plot& plot, const std::string& name) {
  return *std::find_if(plot.series.begin(), plot.series.end(),
                       [&](const Series& series) { return series.name == name; });
}

TEST(SpeedErrorFigure, AFailureIsAGapInItsLine) {
  SpeedError study = some_study();
  study.points[1].errors.is_failed = true;
  const std::vector<Plot> plots = plots_of(study);
  EXPECT_TRUE(std::isnan(series_named(plots[0], "the paper's step").y[0]));
  EXPECT_FALSE(std::isnan(series_named(plots[1], "the paper's step").y[0]));
  EXPECT_TRUE(std::isnan(series_named(plots[1], "the paper's step").y[1]));
}

TEST(SpeedErrorFigure, WithoutASteadyClockItHasNoCosts) {
  SpeedError study = some_study();
  EXPECT_EQ(speed_error_figure(study, 0, "m").legend.size(), 2u);
  study.probe.drift_rel = 0.4;
  const Figure figure = speed_error_figure(study, 0, "m");
  EXPECT_FALSE(has(figure.subtitle, "median"));
  EXPECT_EQ(figure.legend.size(), 1u) << "no Pareto front";
  const std::vector<Plot> plots = plots_of(study);
  EXPECT_TRUE(plots[0].series.empty());
  EXPECT_EQ(plots[0].when_empty, "not measured: clock unsteady (drift 40 %, at most 25 %)");
  EXPECT_EQ(plots[1].series.size(), 3u) << "two methods and the rings";
}

TEST(SpeedErrorFigure, ZeroHasALineOfItsOwnBelowTheLeastError) {
  SpeedError study = some_study();
  const auto has_text = [&](const std::string& text) {
    return std::ranges::any_of(plots_of(study)[0].texts,
                               [&](const PointText& each) { return each.text == text; });
  };
  EXPECT_FALSE(has_text("no error at all"));
  study.points[4].errors.position_px = 0.0;
  study.points[5].errors.position_px = 2e-15;
  const std::vector<Plot> plots = plots_of(study);
  for (const Plot& plot : plots) EXPECT_DOUBLE_EQ(plot.y.zero_at, 1e-17);
  EXPECT_TRUE(has_text("no error at all"));
}

TEST(SpeedErrorVerdict, SaysWhatWasNotMeasuredAndWhatNoMethodReaches) {
  SpeedError study = some_study();
  study.cheapest = {{.problem = 0, .error_px = 1e-9}};
  const std::string steady = described(speed_error_verdict(study, "some machine", false));
  EXPECT_TRUE(has(steady, "Speed against error on some machine; its clock was steady to 0.0 %."));
  EXPECT_TRUE(has(steady, "'no method at any rate'")) << steady;
  EXPECT_TRUE(has(steady, "'at no rate'"));
  EXPECT_TRUE(has(steady, "cost_at_60_Hz,_ns/s: : 2: '600 (540 .. 720)' x2"));
  EXPECT_TRUE(has(steady, "set-up,_ns: : 2: '-' x2"));
  study.probe.drift_rel = 0.4;
  for (WorkPoint& point : study.points) point.cost = {};
  const std::string unsteady = described(speed_error_verdict(study, "some machine", false));
  EXPECT_TRUE(has(unsteady,
                  "Speed against error on some machine; costs are not measured: clock unsteady "
                  "(drift 40 %, at most 25 %)."));
  EXPECT_TRUE(has(unsteady, "cost_at_60_Hz,_ns/s: : 2: '-' x2"));
  EXPECT_FALSE(has(unsteady, "cheapest"));
}

TEST(SpeedErrorTables, HaveNoErrorsWhereAMethodFailed) {
  SpeedError study = some_study();
  study.points[1].errors.is_failed = true;
  const std::string points = described(speed_error_tables(study, "some machine").front());
  EXPECT_TRUE(has(points, "failed, 1: 1: the method gave up: 6: 0 1 0 0 0 0\n"));
  EXPECT_TRUE(
      has(points, "position_error, px: largest distance from the exact fling: 6 (1 missing): 30 240"));
}

}  // namespace
}  // namespace hyrax
