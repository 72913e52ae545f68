// Drawing of figures made by hand.
#include <gtest/gtest.h>

#include "tools/report/figure_script.h"

namespace hyrax {
namespace {

bool has(const std::string& script, const std::string& text) { return script.find(text) != script.npos; }

TEST(FigureScript, ABandIsTheAreaBetweenItsEnds) {
  Plot plot;
  plot.series = {{.look = {.form = Form::band}, .x = {1, 2, 2}, .y = {5, 5, 7}, .y_low = {0, 0, 3}}};
  const std::string script = figure_script({.body = std::vector{plot}});
  EXPECT_TRUE(has(script, "$plot0_0 << EOD\n1 5 0\n2 5 0\n2 7 3\nEOD\n"));
  EXPECT_TRUE(has(script, "$plot0_0 using 1:3:2"));
}

TEST(FigureScript, ASignOfTheLegendKeepsItsObject) {
  Plot plot;
  plot.series = {{.x = {1, 2}, .y = {5, 6}}};
  const std::string script =
      figure_script({.body = std::vector{plot}, .legend = {{"band", {.form = Form::band}}}});
  EXPECT_FALSE(has(script, "set object 2 ")) << "object 2 is the first sign";
}

TEST(FigureScript, DecimalsAreThoseOfTheOneAxis) {
  Plot plot;
  plot.series = {{.x = {1, 2}, .y = {5, 6}}};
  EXPECT_FALSE(has(figure_script({.body = std::vector{plot}}), "set format"));
  plot.y.decimals = 3;
  const std::string script = figure_script({.body = std::vector{plot, plot}});
  EXPECT_TRUE(has(script, "set format y '%.3f'"));
  EXPECT_FALSE(has(script, "set format x"));
  EXPECT_TRUE(has(script, "set format\n")) << "the second plot has its own";
}

}  // namespace
}  // namespace hyrax
