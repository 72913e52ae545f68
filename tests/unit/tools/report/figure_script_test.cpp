// gnuplot's scripts of figures.
#include <gtest/gtest.h>

#include "tools/report/figure_script.h"

namespace hyrax {
namespace {

bool has(const std::string& script, const std::string& text) { return script.find(text) != script.npos; }

TEST(FigureScript, BarsGoFromTheLowEndOfTheAxisInTheirColour) {
  Plot plot{.x = {.is_logarithmic = true, .low = 0.1, .high = 1000.0},
            .y = {.categories = {"gravity", "drag"}}};
  plot.series = {{.look = {.form = Form::bars, .tone = Tone::blue}, .x = {941.0}, .y = {0.0}},
                 {.look = {.form = Form::bars, .tone = Tone::orange}, .x = {1e-3}, .y = {1.0}}};
  plot.marks = {{.at = 1.0, .text = "tolerance"}};
  const std::string script = figure_script({.title = "Bars", .body = std::vector{plot}});
  EXPECT_TRUE(has(script,
                  "from first 0.1, first -0.32 to first 941, first 0.32 front fs solid 1 noborder fc "
                  "rgb '#0072b2'"));
  EXPECT_TRUE(has(script, "from first 0.1, first 0.68 to first 0.1, first 1.32"))
      << "no bar left of the axis";
  EXPECT_TRUE(has(script, "'gravity' 0, 'drag' 1"));
  EXPECT_TRUE(has(script, "set arrow from first 1, graph 0 to first 1, graph 1"));
}

TEST(FigureScript, APartOfAGridsFieldHasItsColourAndText) {
  Grid grid{.rows = {"rest"}, .columns = {{"comes-to-rest", Tone::ink}}};
  grid.cells = {{0, 0, Tone::good, "7", 0.0, 0.5}, {0, 0, Tone::bad, "17", 0.5, 1.0}};
  const std::string script = figure_script({.title = "Grid", .body = grid});
  for (const char* const part : {"fc rgb '#cfe8df'", "fc rgb '#f1b594'", "set label '7'", "set label '17'"})
    EXPECT_TRUE(has(script, part)) << part;
  EXPECT_FALSE(has(script, "fc rgb '#f6dfa9'"));
}

}  // namespace
}  // namespace hyrax
