// The study speed-error as a user gets it: its figures' data, tables, verdict and refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/core/shipped_core.h"
#include "sim/study/speed_error/speed_error.h"
#include "sim/study/study.h"
#include "tests/unit/sim/study/clocks.h"

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
      point.cost = {{9.0 * rate_hz, 10.0 * rate_hz, 12.0 * rate_hz},
                    {10.0 * rate_hz, 9.0 * rate_hz, 12.0 * rate_hz}};
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

TEST(SpeedErrorFigure, EachLineHasItsNameAndOrderAndTheSubtitleTheMachine) {
  const Figure figure = speed_error_figure(some_study(), 0, "some machine");
  const std::vector<PointText>& names = std::get<std::vector<Plot>>(figure.body)[1].texts;
  ASSERT_EQ(names.size(), 2u);
  for (const PointText& name : names) {
    EXPECT_EQ(name.x, 1.0 / 30.0) << "the end of the line, where frames are longest";
  }
  EXPECT_EQ(names[0].text, "velocity Verlet: order 1.00");
  EXPECT_EQ(names[1].text, "the paper's step: order −1.00") << "over the others";
  EXPECT_TRUE(has(figure.subtitle, "20 repetitions on some machine"));
}

TEST(SpeedErrorFigure, DrawsErrorAgainstCostOfSixtyRowsWithItsIntervalAndAgainstDt) {
  const std::vector<Plot> plots = plots_of(some_study());
  const Series& cost = series_named(plots[0], "velocity Verlet");
  EXPECT_EQ(cost.x, (std::vector{600.0, 2400.0}));
  EXPECT_EQ(cost.y, (std::vector{1.0 / 60.0, 1.0 / 240.0}));
  EXPECT_EQ(cost.x_low, (std::vector{540.0, 2160.0}));
  EXPECT_EQ(cost.x_high, (std::vector{720.0, 2880.0}));
  const Series& dt = series_named(plots[1], "velocity Verlet");
  EXPECT_EQ(dt.x, (std::vector{1.0 / 30.0, 1.0 / 60.0, 1.0 / 240.0}));
  EXPECT_TRUE(dt.x_low.empty());
  ASSERT_EQ(plots[1].marks.size(), 1u);
  EXPECT_EQ(plots[1].marks[0].at, 1.0 / 60.0);
  EXPECT_EQ(plots[1].marks[0].text, "laws defined at 60 Hz");
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

TEST(SpeedErrorFigure, SixtyHertzIsRingedInBothPlotsAndPointsHaveTheirRates) {
  for (const Plot& plot : plots_of(some_study())) {
    const Series& ring = series_named(plot, "60 Hz");
    EXPECT_EQ(ring.look.marker, Marker::ring);
    EXPECT_EQ(ring.x.size(), 2u) << "one on each method's line";
  }
  EXPECT_EQ(series_named(plots_of(some_study())[1], "velocity Verlet").point_names,
            (std::vector<std::string>{"30 Hz", "60 Hz", "240 Hz"}));
}

TEST(SpeedErrorFigure, TheTruthIsALimitAndNoCurve) {
  SpeedError study = some_study();
  study.methods.push_back(frame_methods(shipped_core()).back());
  study.points.push_back({0, 2, 60.0, {}, cost_of({700.0})});
  const std::vector<Plot> plots = plots_of(study);
  ASSERT_EQ(plots[0].marks.size(), 1u);
  EXPECT_EQ(plots[0].marks[0].at, 700.0);
  EXPECT_EQ(plots[0].marks[0].text, "the reference: event-driven");
  EXPECT_EQ(plots[0].series.size(), 4u) << "two methods, the front and the rings";
  EXPECT_EQ(plots[1].series.size(), 3u);
}

TEST(BandsFigure, HasALineForEachMethod) {
  SpeedError study = some_study();
  EXPECT_FALSE(bands_figure(study, 0));
  study.bands = {{.method = 0, .rate_hz = 60.0, .position_px = {120, 40.0, 20.0, 60.0}, .nearer = {0, 120}},
                 {.method = 1, .rate_hz = 60.0, .position_px = {120, 44.0, 21.0, 66.0}, .nearer = {49, 120}}};
  const Plot plot = std::get<std::vector<Plot>>(bands_figure(study, 0)->body).front();
  EXPECT_EQ(plot.y.categories, (std::vector<std::string>{"the paper's step", "velocity Verlet"}));
  EXPECT_EQ(plot.series[0].x, (std::vector{40.0, 44.0}));
  EXPECT_EQ(plot.series[0].x_low, (std::vector{20.0, 21.0}));
  EXPECT_EQ(plot.series[0].x_high, (std::vector{60.0, 66.0}));
  ASSERT_EQ(plot.texts.size(), 1u);
  EXPECT_EQ(plot.texts[0].text, "ends nearer in 49 of 120");
  EXPECT_EQ(
      nearness_sentence(study.bands[1], study),
      "At 60 Hz the velocity Verlet ends nearer to the exact place than the paper's step in 49 of 120 flings "
      "(32 .. 50 %): it is farther.");
}

TEST(SpeedErrorFigure, RingsTheParetoFront) {
  SpeedError study = some_study();
  EXPECT_TRUE(series_named(plots_of(study)[0], "Pareto front").x.empty());
  study.points[4].is_pareto = true;
  EXPECT_EQ(series_named(plots_of(study)[0], "Pareto front").x, std::vector{600.0});
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

TEST(SpeedErrorFigure, TheSentencesOnFreeFlightAreOnlyOnItsFigure) {
  SpeedError study = some_study();
  study.problems.push_back(study.problems.front());
  for (std::size_t i = 0; i < 6; ++i) {
    study.points.push_back(study.points[i]);
    study.points.back().problem = 1;
  }
  EXPECT_FALSE(speed_error_figure(study, 0, "").remarks.empty());
  EXPECT_TRUE(speed_error_figure(study, 1, "").remarks.empty());
}

TEST(SpeedErrorFigure, NamesEveryStepperAtItsMostAccuratePoint) {
  SpeedError study = some_study();
  for (const char* name : {"rkck", "rk4imp"})
    for (const double tolerance : {1e-4, 1e-6}) {
      study.methods.push_back(
          {.name = name, .family = std::string("GSL ") + name, .accuracy = Adaptive{tolerance}});
      WorkPoint point{0, study.methods.size() - 1, 60.0, {}, {}};
      point.errors.position_px = tolerance;
      point.cost = cost_of({1.0 / tolerance});
      study.points.push_back(point);
      point.rate_hz = 1.0;  // The end only.
      study.points.push_back(point);
    }
  const std::vector<Plot> plots = plots_of(study);
  ASSERT_EQ(plots[0].texts.size(), 4u) << "two rates of the paper's step before them";
  EXPECT_EQ(plots[0].texts[2].text, "rkck");
  EXPECT_EQ(plots[0].texts[3].text, "rk4imp");
  EXPECT_EQ(plots[0].texts[3].y, 1e-6);
  EXPECT_EQ(series_named(plots[0], "GSL rkck").x.size(), 2u);
  EXPECT_EQ(series_named(plots[0], "GSL rkck, end only").x.size(), 2u);
  EXPECT_EQ(plots[1].series.size(), 3u) << "no adaptive method is drawn against dt";
}

TEST(ConvergenceSentences, HaveTheValuesOfTheStudy) {
  const std::vector<std::string> sentences = convergence_sentences(some_study());
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_TRUE(has(sentences[1], "its error is 9.8 px at 60 Hz and 42 px at 240 Hz"));
  EXPECT_TRUE(convergence_sentences({}).empty());
}

const Study& the_study() {
  return *std::find_if(studies().begin(), studies().end(),
                       [](const Study& study) { return study.name == "speed-error"; });
}

StudyRequest quick_request() {
  return {.core = shipped_core(), .is_quick = true, .machine = "some machine", .now_ns = steady_ns};
}

TEST(SpeedErrorStudy, AScenarioWithANameThatIsTakenIsRefused) {
  StudyRequest request = quick_request();
  NamedScenario given{"mine.json", {}};
  given.scenario.name = "fling";
  given.scenario.window = {1920, 1080};
  given.scenario.sprite = {128, 128};
  given.scenario.clock.base = FixedRate{60.0};
  given.scenario.length = std::int64_t{60};
  request.scenarios = {given};
  EXPECT_THROW(static_cast<void>(the_study().run(request)), RequestRefused);
}

}  // namespace
}  // namespace hyrax
