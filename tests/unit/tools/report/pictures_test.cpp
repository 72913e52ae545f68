// Pictures, compared with approved ones to the last line of their SVG.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/stored_run.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/report/picture_faults.h"
#include "tools/report/figure_json.h"
#include "tools/report/figure_svg.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

void expect_picture(const std::string& name, const std::string& svg) {
  EXPECT_EQ(picture_faults(svg), std::vector<std::string>{}) << name;
  expect_approved("tests/unit/tools/report/pictures/" + name, svg);
}

// Plots below each other with all that a plot may have; the widest ticks are those of the second.
Figure stacked_plots() {
  const Axis time{.label = "time, s", .low = 0.0, .high = 12.0};
  Plot errors{
      .x = time,
      .y = {.label = "distance, px", .is_logarithmic = true, .strip_below = 1e-9, .strip_name = "rounding"}};
  errors.series = {
      {.name = "a gap",
       .look = {.tone = Tone::blue},
       .x = {0, 3, 4, 5, 9},
       .y = {0.01, 0.4, kNotGiven, 0.7, 20}},
      {.name = "far below",
       .look = {.tone = Tone::green, .width_px = 1.5, .dash = Dash::dots},
       .x = {0, 12},
       .y = {1e-12, 3e-11}},
      {.name = "spread",
       .look = {.form = Form::points, .tone = Tone::purple, .marker = Marker::square, .marker_size = 1.0},
       .x = {2, 7},
       .y = {2, 0.02},
       .x_low = {1, 6.5},
       .x_high = {2.25, 8},
       .point_names = {"60 Hz", "144 Hz"}},
      {.name = "joined",
       .look = {.form = Form::line_and_points, .dash = Dash::short_dashes, .marker = Marker::ring},
       .x = {10, 11.5},
       .y = {0.1, 0.2}}};
  errors.marks = {{.at = 6.0, .text = "six", .tone = Tone::vermilion},
                  {.at = 5.9, .text = "a little earlier"},
                  {.at = 13.0, .text = "beyond"},
                  {.at = HUGE_VAL, .text = "never"},
                  {.is_vertical = false, .at = -HUGE_VAL, .text = "below all"},
                  {.is_vertical = false, .at = 0.1, .text = "allowed", .tone = Tone::orange}};
  errors.texts = {{9, 20, "the end"}, {9, 20, "said twice", Tone::blue}, {2, 2, "two"}};
  errors.spans = {{1, 2}, {11, 14}};
  errors.top_dots = {{3, Tone::sky_blue}, {8, Tone::orange}};
  Plot heights{
      .x = time,
      .y = {.label = "height, px", .is_reversed = true, .low = -3000.0, .high = 3000.0, .decimals = 1}};
  heights.series = {{.name = "range",
                     .look = {.form = Form::band, .tone = Tone::lavender},
                     .x = {0, 6, 12},
                     .y = {1000, 2500, 2000},
                     .y_low = {-1000, 0, -2000}}};
  Figure figure{
      .suffix = "-all",
      .title = "it's <b> & \"q\"\n\\",
      .subtitle = "Below each other, with one axis of time",
      .note = "a note",
      .body = std::vector{errors, heights,
                          Plot{.x = time, .y = {.label = "cost, ns"}, .when_empty = "not measured"}},
      .remarks = {"First remark.", "Second remark."}};
  for (const Plot& plot : {errors, heights})
    for (const Series& series : plot.series) figure.legend.push_back({series.name, series.look});
  figure.legend.push_back(
      {"every other arc, which is a long text that has more than a line where the sheet is narrow and ends "
       "below the others",
       {.form = Form::band, .tone = Tone::shade}});
  return figure;
}

// Beside each other: bars with their texts, points of equal scales in both directions, and ticks that were
// chosen.
Figure plots_beside() {
  Plot bars{.x = {.label = "cost, ns",
                  .is_logarithmic = true,
                  .low = 0.5,
                  .high = 50'000.0,
                  .zero_at = 1.0,
                  .zero_text = "none"},
            .y = {.categories = {"gravity", "half-step", "lift"}}};
  bars.series = {
      {.name = "needed", .look = {.form = Form::bars, .tone = Tone::blue}, .x = {400, 0}, .y = {0, 1}},
      {.name = "not needed", .look = {.form = Form::bars, .tone = Tone::orange}, .x = {20}, .y = {2}},
      {.name = "again", .look = {.form = Form::points, .marker = Marker::ring}, .x = {40}, .y = {1}}};
  bars.texts = {{400, 0, "941 px, 11 moved"}, {0, 1, "below"}, {20, 2, "20 ns", Tone::orange}};
  Plot places{.x = {.label = "x, px"}, .y = {.label = "y, px"}, .has_equal_scales = true};
  places.series = {
      {.name = "circle", .look = {.tone = Tone::green}, .x = {0, 30, 60, 30, 0}, .y = {20, 0, 20, 40, 20}}};
  places.texts = {{60, 20, "circle: 1 px"}};
  Plot rates{.x = {.label = "rate",
                   .low = 0.0,
                   .high = 100.0,
                   .ticks = {{60, "60 Hz"}, {24, "24 Hz"}, {120, "120 Hz"}}},
             .y = {.label = "far away, px", .low = 1e7, .high = 3e7}};
  rates.series = {{.name = "rates", .look = {.tone = Tone::vermilion}, .x = {24, 30}, .y = {2e7, 1.5e7}}};
  rates.texts = {{30, 1.5e7, "rates: a few"}};
  return {.title = "Beside each other",
          .body = std::vector{bars, places, rates},
          .legend = {{"bars", {.form = Form::bars, .tone = Tone::blue}},
                     {"circle", {.tone = Tone::green}},
                     {"dashes", {.dash = Dash::long_dashes}},
                     {"good", {.form = Form::band, .tone = Tone::good}}}};
}

// On a narrow sheet a row's name is above its fields.
Figure some_grid() {
  Grid grid{.rows = {"comes to rest", "window-grows-under-the-sprite"},
            .columns = {{"calm", Tone::ink}, {"wild", Tone::vermilion}}};
  grid.columns.resize(16, {"stays-inside", Tone::ink});
  grid.cells = {{0, 0, Tone::good, "25"},
                {0, 15, Tone::good, "7", 0.0, 0.5},
                {0, 15, Tone::bad, "17", 0.5, 1.0},
                {1, 0, Tone::notable, "a text without room"},
                {1, 1}};
  return {.title = "Grid", .note = "all hold", .note_tone = Tone::green, .body = grid};
}

Figure some_list() {
  Listing listing{.columns = {{"", 60.0, false, 0},
                              {"what is claimed", 200.0, false, 20},
                              {"verdict", 100.0, false, 0},
                              {"measured", 90.0, true, 0}}};
  listing.rows = {{{"3.1"},
                   {"it comes to rest in a moment", "where the floor takes a little of its speed"},
                   {"holds", "", Tone::good},
                   {"0.6"}},
                  {{"3.2"}, {"short"}, {"no", "why", Tone::bad}, {"12", "of 14"}}};
  return {.title = "List", .body = listing};
}

TEST(Pictures, OfFiguresAreThoseApproved) {
  for (const auto& [name, figure] : {std::pair("stacked", stacked_plots()),
                                     {"beside", plots_beside()},
                                     {"grid", some_grid()},
                                     {"list", some_list()}}) {
    expect_picture(std::string(name) + ".svg", figure_svg(figure));
    const std::string json = to_text(Json::Array{figure_json(figure)});
    expect_approved("tests/unit/tools/report/pictures/" + std::string(name) + ".json", json);
    EXPECT_EQ(to_text(Json::Array{figure_json(figures_of(parse_json(json, "text"), "figures").front())}),
              json)
        << name;
  }
  expect_picture("beside.html", figure_html(plots_beside()));
  expect_picture("grid.html", figure_html(some_grid()));
  expect_picture("list.html", figure_html(some_list()));
}

// A throw into a corner, a hand's way, other sizes of window and sprite, and rows that were not recorded.
TEST(Pictures, OfARunIsTheOneApproved) {
  Scenario scenario = fling_at(60.0, 150,
                               {{40, Grab{}},
                                {41, Place{{200.0, 300.0}}},
                                {44, Release{{900.0, -1200.0}}},
                                {80, Resize{Size{800, 600}, {}}},
                                {120, Resize{{}, Size{64, 160}}}});
  scenario.name = "thrown twice";
  scenario.window = {1000, 600};
  scenario.start = {500.0, 100.0};
  scenario.start_velocity = {3000.0, 3000.0};
  RunRecorder recorder(step_count(scenario));
  static_cast<void>(replay(shipped_core(), scenario, recorder));
  const StoredRun run = recorder.take();
  Columns rows;
  for (std::size_t row = 0; row < run.rows.size(); ++row)
    if (row < 60 || row > 75) rows.append(run.rows.row(row));
  expect_picture("run.svg", run_svg(scenario, rows, run.contacts));
}

}  // namespace
}  // namespace hyrax
