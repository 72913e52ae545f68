// The scripts of the studies' pictures.
#include <gtest/gtest.h>

#include "tools/report/hard_cases_figure.h"
#include "tools/report/needs_figure.h"
#include "tools/report/rest_figures.h"
#include "tools/report/speed_error_figure.h"

namespace hyrax {
namespace {

bool has(const std::string& script, const std::string& words) { return script.find(words) != script.npos; }

// One flight, two methods at three rates each.
SpeedError some_study() {
  SpeedError study;
  study.problems = {study_problems().front()};
  const std::vector<MethodKind> methods = frame_methods();
  study.methods = {methods[0], methods[4]};
  for (std::size_t method = 0; method < 2; ++method)
    for (const double rate_hz : {15.0, 60.0, 240.0}) {
      WorkPoint point{0, method, rate_hz, {}, {}};
      point.errors.position_px = method == 0 ? rate_hz : 1.0 / rate_hz;
      point.cost.median_ns = 10.0 * rate_hz;
      study.points.push_back(point);
    }
  study.orders = {{0, 0, 3, -1.0}, {0, 1, 3, 1.0}};
  study.paper = {{.rate_hz = 60.0, .model_px = 9.8}, {.rate_hz = 240.0, .model_px = 42.0}};
  study.repetitions = 20;
  return study;
}

TEST(SpeedErrorFigure, TellsOrdersAndTheMachine) {
  const std::string script = speed_error_script(some_study(), 0, "some machine");
  EXPECT_TRUE(has(script, "the paper''s step: order −1.00, grows"));
  EXPECT_TRUE(has(script, "velocity Verlet: order 1.00"));
  EXPECT_TRUE(has(script, "20 repetitions on some machine"));
  EXPECT_EQ(script, speed_error_script(some_study(), 0, "some machine"));
}

TEST(SpeedErrorFigure, AFailureIsAGapInItsLine) {
  SpeedError study = some_study();
  EXPECT_FALSE(has(speed_error_script(study, 0, ""), "NaN NaN NaN"));
  study.points[1].errors.is_failed = true;
  EXPECT_TRUE(has(speed_error_script(study, 0, ""), "150 15 0.0666667\nNaN NaN NaN\n2400 240 0.00416667\n"));
}

TEST(SpeedErrorFigure, RingsTheParetoFront) {
  SpeedError study = some_study();
  study.points[3].is_pareto = true;
  EXPECT_TRUE(has(speed_error_script(study, 0, ""), "$front << EOD\n150 0.0666667\nEOD"));
}

TEST(SpeedErrorFigure, ZeroHasALineOfItsOwnMarkedSo) {
  SpeedError study = some_study();
  EXPECT_FALSE(has(speed_error_script(study, 0, ""), "no error at all"));
  study.points[3].errors.position_px = 0.0;
  study.points[4].errors.position_px = 2e-15;
  const std::string script = speed_error_script(study, 0, "");
  EXPECT_TRUE(has(script, "set ytics add ('0' 1e-17)"));
  EXPECT_TRUE(has(script, "no error at all"));
  EXPECT_TRUE(has(script, " 2e-15 ")) << "more than nothing";
}

TEST(SpeedErrorFigure, MarksTheRateThatDefinesTheLaws) {
  EXPECT_TRUE(has(speed_error_script(some_study(), 0, ""), "'laws defined at 60 Hz' at first 0.016666667"));
}

TEST(SpeedErrorFigure, TheSentenceOnFreeFlightIsOnItsPictureAlone) {
  SpeedError study = some_study();
  study.problems.push_back(study.problems.front());
  for (std::size_t i = 0; i < 6; ++i) {
    study.points.push_back(study.points[i]);
    study.points.back().problem = 1;
  }
  EXPECT_TRUE(has(speed_error_script(study, 0, ""), "Drag by the frame keeps"));
  EXPECT_FALSE(has(speed_error_script(study, 1, ""), "Drag by the frame keeps"));
}

TEST(SpeedErrorFigure, NamesEveryStepper) {
  SpeedError study = some_study();
  for (const char* family : {"GSL rkck", "GSL rk4imp"}) {
    study.methods.push_back({.name = family, .words = family, .family = family, .tolerance = 1e-6});
    WorkPoint point{0, study.methods.size() - 1, 60.0, {}, {}};
    point.errors.position_px = 1e-3;
    point.cost.median_ns = 1e3;
    study.points.push_back(point);
  }
  const std::string script = speed_error_script(study, 0, "");
  EXPECT_TRUE(has(script, "'rkck' at first"));
  EXPECT_TRUE(has(script, "'rk4imp' at first"));
}

TEST(ConvergenceSentence, HasTheFiguresOfTheStudy) {
  EXPECT_TRUE(has(convergence_sentence(some_study()), "9.8 px of error at 60 Hz become 42 px at 240 Hz"));
  EXPECT_EQ(convergence_sentence({}), "");
}

// From all in residual speed to all at zero speed, at the boundary between the two rates.
TEST(RestMap, StepsAtTheBoundaryBetweenTwoRates) {
  RateEnds slow, fast;
  slow.rate_hz = 60.0;
  slow.flings[static_cast<std::size_t>(FinalState::buzz)] = 5;
  fast.rate_hz = 240.0;
  fast.flings[static_cast<std::size_t>(FinalState::rest)] = 5;
  EXPECT_TRUE(has(rest_map_script({slow, fast}, {{"some", 144.0, std::nullopt}}),
                  "60 100 100 100\n144 100 100 100\n144 0 0 100\n240 0 0 100\n"));
  EXPECT_TRUE(has(rest_map_script({slow, fast}, {}), "\n120 100 100 100\n120 0 0 100\n"));
}

TEST(HardCasesFigure, AVerdictHasItsColourInACellOfSeveral) {
  std::vector<PlayedCase> cases(2);
  for (PlayedCase& played : cases) {
    played.hard_case.made_from = "some-scene";
    played.result.measures[0].is_asked = true;
  }
  cases[1].result.measures[0].holds = false;
  const std::string script = hard_cases_figure_script(cases);
  for (const char* fill : {"fc rgb '#cfe8df'", "fc rgb '#f1b594'"})
    EXPECT_NE(script.find(fill), script.rfind(fill)) << fill << " is in the legend only";
}

SceneNeeds some_scene() {
  SceneNeeds scene;
  scene.scenario = "some-fling";
  scene.parts = {{"gravity", Part::gravity, {false, 941.0, 105.0, 1, 11}, Need::needed, 0.0},
                 {"drag", Part::drag, {false, 0.5, 0.5, 1, 1}, Need::below, 0.0},
                 {"top", Part::top_wall, {}, Need::not_exercised, 0.0}};
  return scene;
}

TEST(NeedsFigure, TellsHowFarThePathMoves) {
  const std::string script = needs_script(some_scene(), 1.0);
  for (const char* words :
       {"What some-fling needs", "941 px, 11 contacts moved", "0.5 px, 1 contact moved", "not exercised"})
    EXPECT_TRUE(has(script, words)) << words;
}

TEST(CoverageFigure, MarksWhatNoScenarioExercises) {
  const std::string script = coverage_script({some_scene()}, 1.0);
  EXPECT_TRUE(has(script, "'gravity'"));
  EXPECT_TRUE(has(script, "'top (never)'"));
  EXPECT_TRUE(has(script, "'some-fling' 0"));
}

}  // namespace
}  // namespace hyrax
