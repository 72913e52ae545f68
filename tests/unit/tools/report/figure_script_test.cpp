// gnuplot's script of figures made by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "tools/report/figure_script.h"

namespace hyrax {
namespace {

bool has(const std::string& script, const std::string& part) { return script.find(part) != script.npos; }

Figure figure_of(Plot plot) { return {.title = "t", .body = std::vector{std::move(plot)}}; }

// Where a label's centre is on the canvas, 0 .. 1 from the left and from below.
std::pair<double, double> label_place(const std::string& script, const std::string& text) {
  std::smatch match;
  const std::regex label("set label '" + text + "' at screen ([0-9.]+),([0-9.]+) center");
  if (!std::regex_search(script, match, label)) return {-1.0, -1.0};
  return {std::stod(match[1]), std::stod(match[2])};
}

TEST(PlotScript, AMissingValueIsAGapInTheLine) {
  const Plot plot{.series = {{.x = {1.0, 2.0, 3.0}, .y = {1.0, std::nan(""), 3.0}}}};
  EXPECT_TRUE(has(figure_script(figure_of(plot)), "1 1\n2 nan\n3 3\n"));
}

TEST(PlotScript, SpreadIsDrawnAsBarsThroughThePoints) {
  Plot plot{.series = {{.x = {1.0, 2.0}, .y = {3.0, 4.0}}}};
  EXPECT_FALSE(has(figure_script(figure_of(plot)), "xerrorbars"));
  plot.series[0].x_low = {0.5, 1.5};
  plot.series[0].x_high = {1.25, 2.25};
  const std::string script = figure_script(figure_of(plot));
  EXPECT_TRUE(has(script, "1 3 0.5 1.25\n"));
  EXPECT_TRUE(has(script, "using 1:2:3:4 notitle with xerrorbars"));
}

TEST(PlotScript, ZeroHasALineOfItsOwnOnALogarithmicAxisAndNoTickBelow) {
  Plot plot{.y = {.is_logarithmic = true, .zero_at = 1e-4}, .series = {{.x = {1.0, 2.0}, .y = {0.0, 1.0}}}};
  const std::string script = figure_script(figure_of(plot));
  EXPECT_TRUE(has(script, "1 0.0001\n2 1\n"));
  EXPECT_TRUE(has(script, "set ytics add ('0' 0.0001)"));
  EXPECT_TRUE(has(script, "1e-3"));
  EXPECT_FALSE(has(script, "1e-4"));
}

TEST(PlotScript, TextsKeepOffCurvesAndOneAnother) {
  Plot plot{.x = {.low = 0.0, .high = 10.0},
            .y = {.low = 0.0, .high = 10.0},
            .texts = {{5.0, 5.0, "first"}, {5.0, 5.0, "second"}}};
  plot.series = {{.x = {5.0}, .y = {5.0}}};
  const std::string free = figure_script(figure_of(plot));
  const auto [x, y] = label_place(free, "first");
  EXPECT_GT(x, 0.5);
  const auto [x_second, y_second] = label_place(free, "second");
  EXPECT_LT(x_second, 0.5) << "the right of the point is taken";
  plot.series = {{.x = {5.0, 9.0}, .y = {5.0, 5.0}}};
  const auto [x_off, y_off] = label_place(figure_script(figure_of(plot)), "first");
  EXPECT_LT(x_off, x) << "a curve goes to the right";
  EXPECT_EQ(y_off, y);
  EXPECT_EQ(y_second, y);
}

TEST(PlotScript, ALineLeadsToALabelThatIsNotBesideItsPoint) {
  const std::string kLeader = " nohead front lw 0.75 ";
  Plot plot{.x = {.low = 0.0, .high = 10.0},
            .y = {.low = 0.0, .high = 10.0},
            .series = {{.x = {5.0}, .y = {5.0}}},
            .texts = {{5.0, 5.0, "first"}}};
  EXPECT_FALSE(has(figure_script(figure_of(plot)), kLeader));
  plot.texts.resize(6, plot.texts.front());
  EXPECT_TRUE(has(figure_script(figure_of(plot)), kLeader))
      << "right, left, above, below and corners are taken";
}

TEST(PlotScript, PlotsShareTheWidthAsTheyAsk) {
  const Plot plot{.series = {{.x = {1.0, 2.0}, .y = {1.0, 2.0}}}};
  Plot wide = plot;
  wide.share = 3.0;
  const auto second_left = [](const std::string& script) {
    return std::stod(script.substr(script.rfind("set lmargin at screen ") + 22));
  };
  const double even = second_left(figure_script({.title = "t", .body = std::vector{plot, plot}}));
  EXPECT_NEAR(second_left(figure_script({.title = "t", .body = std::vector{wide, plot}})), even + 0.25, 1e-6);
}

TEST(PlotScript, APlotWithoutPointsSaysWhyAndHasNoAxes) {
  const Plot drawn{.y = {.label = "distance, px"}, .series = {{.x = {1.0, 2.0}, .y = {1.0, 2.0}}}};
  const Plot empty{.y = {.label = "cost, ns"}, .when_empty = "not measured"};
  for (const std::vector<Plot>& plots : {std::vector{empty, drawn}, {drawn, empty}}) {
    const std::string script = figure_script({.title = "t", .body = plots});
    EXPECT_TRUE(has(script, "set label 'not measured' at graph 0.5,0.5 center"));
    EXPECT_TRUE(has(script, "1 1\n2 2\n"));
    EXPECT_TRUE(has(script, "'distance, px'"));
    EXPECT_FALSE(has(script, "'cost, ns'"));
  }
  const std::string script = figure_script({.title = "t", .body = std::vector{drawn, drawn}});
  EXPECT_FALSE(has(script, "at graph 0.5,0.5 center"));
}

TEST(Legend, IsARowIfItFitsAndElseColumnsReadDownwards) {
  const auto place = [](const std::string& script, const std::string& text) {
    std::smatch match;
    std::regex_search(script, match,
                      std::regex("set label '" + text + "' at screen ([0-9.]+),([0-9.]+) left"));
    return std::pair{std::stod(match[1]), std::stod(match[2])};
  };
  Figure figure = figure_of({.series = {{.x = {1.0}, .y = {1.0}}}});
  figure.legend = {{"one", {}}, {"two", {}}, {"three", {}}};
  const std::string row = figure_script(figure);
  EXPECT_EQ(place(row, "one").second, place(row, "three").second);
  const std::string long_end(50, '.');
  for (LegendEntry& entry : figure.legend) entry.text += long_end;
  const std::string columns = figure_script(figure);
  EXPECT_EQ(place(columns, "one" + long_end).first, place(columns, "two" + long_end).first);
  EXPECT_GT(place(columns, "one" + long_end).second, place(columns, "two" + long_end).second);
  EXPECT_EQ(place(columns, "one" + long_end).second, place(columns, "three" + long_end).second);
}

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
