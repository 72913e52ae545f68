// The scripts of the studies' pictures.
#include <gtest/gtest.h>

#include "tools/report/hard_cases_figure.h"
#include "tools/report/needs_figure.h"
#include "tools/report/rest_figures.h"

namespace hyrax {
namespace {

bool has(const std::string& script, const std::string& words) { return script.find(words) != script.npos; }

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
