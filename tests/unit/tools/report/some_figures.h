// Figures that have all that a picture may show.
#pragma once

#include <cmath>

#include "sim/result/figure.h"

namespace hyrax {

// Plots below each other with all that a plot may have, texts that meet and that have no room; the widest
// ticks are those of the second. A long text is broken.
inline Figure stacked_figure() {
  const Axis time{.label = "time, s", .low = 0, .high = 12};
  const std::vector<Series> series = {
      {.name = "a gap",
       .look = {.tone = Tone::blue},
       .x = {0, 3, 4, 5, 9},
       .y = {0.01, 0.4, kNotGiven, 0.7, 20}},
      {.name = "far below",
       .look = {.tone = Tone::green, .width_px = 1.5, .dash = Dash::dots},
       .x = {0, 12},
       .y = {1e-12, 3e-11}},
      {.name = "spread",
       .look = {.form = Form::points, .tone = Tone::purple, .marker = Marker::square, .marker_size = 1},
       .x = {2, 7},
       .y = {2, 0.02},
       .x_low = {1, 6.5},
       .x_high = {2.25, 8},
       .point_names = {"60 Hz", "144 Hz"}},
      {.name = "joined",
       .look = {.form = Form::line_and_points, .dash = Dash::short_dashes, .marker = Marker::ring},
       .x = {10, 11.5},
       .y = {0.1, 0.2}},
      {.name = "range",
       .look = {.form = Form::band, .tone = Tone::lavender},
       .x = {0, 6, 12},
       .y = {1000, 2500, 2000},
       .y_low = {-1000, 0, -2000}}};
  const Plot distance{
      .x = time,
      .y = {.label = "distance, px", .is_logarithmic = true, .strip_below = 1e-9, .strip_name = "rounding"},
      .series = {series.begin(), series.end() - 1},
      .marks = {{.at = 6, .text = "six", .tone = Tone::vermilion},
                {.at = 5.9, .text = "a little earlier"},
                {.at = 13, .text = "beyond"},
                {.at = 11.8, .text = "a text that ends at the right"},
                {.at = 11.9, .text = "no room"},
                {.at = HUGE_VAL, .text = "never"},
                {.is_vertical = false, .at = -HUGE_VAL, .text = "below all"},
                {.is_vertical = false, .at = 0.1, .text = "allowed", .tone = Tone::orange}},
      .texts = {{9, 20, "the end"}, {9, 20, "said twice", Tone::blue}, {2, 2, "two"}},
      .spans = {{1, 2}, {11, 14}},
      .top_dots = {{3, Tone::sky_blue}, {8, Tone::orange}}};
  const Plot height{
      .x = time,
      .y = {.label = "height, px", .is_reversed = true, .low = -3000, .high = 3000, .decimals = 1},
      .series = {series.back()},
      .marks = {{.is_vertical = false, .at = -5000, .text = "below"}}};
  const std::string half = ", which takes a sentence of more than one line";
  const Plot cost{.x = time, .y = {.label = "cost, ns"}, .when_empty = "not measured" + half + half};
  Figure figure{.suffix = "-all",
                .title = "it's <b> & \"q\"\n\\",
                .subtitle = "Below each other, with one axis of time",
                .note = "a note",
                .body = std::vector{distance, height, cost},
                .remarks = {"First remark.", "Second remark."}};
  for (const Series& each : series) figure.legend.push_back({each.name, each.look});
  figure.legend.push_back(
      {"every other arc, which is a long text that has more than a line where the sheet is "
       "narrow and ends below the others",
       {.form = Form::band, .tone = Tone::shade}});
  return figure;
}

// Bars with their texts, points of equal scales in both directions, ticks that were chosen, a line without a
// text, which takes no room, and a series whose name begins that of another.
inline Figure beside_figure() {
  const Plot bars{
      .x = {.label = "cost, ns",
            .is_logarithmic = true,
            .low = 0.5,
            .high = 5e4,
            .zero_at = 1,
            .zero_text = "none"},
      .y = {.categories = {"gravity", "half-step", "lift"}},
      .series =
          {{.name = "needed", .look = {.form = Form::bars, .tone = Tone::blue}, .x = {400, 0}, .y = {0, 1}},
           {.name = "not needed", .look = {.form = Form::bars, .tone = Tone::orange}, .x = {20}, .y = {2}},
           {.name = "again", .look = {.form = Form::points, .marker = Marker::ring}, .x = {40}, .y = {1}}},
      .texts = {{400, 0, "941 px, 11 moved"}, {0, 1, "below"}, {20, 2, "20 ns", Tone::orange}}};
  const Plot circle{.x = {.label = "x, px"},
                    .y = {.label = "y, px"},
                    .series = {{.name = "circle",
                                .look = {.tone = Tone::green},
                                .x = {0, 30, 60, 30, 0},
                                .y = {20, 0, 20, 40, 20}}},
                    .marks = {{.at = 30, .tone = Tone::vermilion}},
                    .texts = {{60, 20, "circle: 1 px"}},
                    .has_equal_scales = true};
  const std::string half = ", or as far as a sentence of more than one line";
  const Plot rates{
      .x = {.label = "rate", .low = 0, .high = 100, .ticks = {{60, "60 Hz"}, {24, "24 Hz"}, {120, "120 Hz"}}},
      .y = {.label = "far away, px" + half + half, .low = 1e7, .high = 3e7},
      .series = {{.name = "rate", .look = {.tone = Tone::green}, .x = {24, 30}, .y = {1.2e7, 1.1e7}},
                 {.name = "rates", .look = {.tone = Tone::vermilion}, .x = {24, 30}, .y = {2e7, 1.5e7}}},
      .texts = {{30, 1.5e7, "rates: a few"}}};
  return {.title = "Beside each other",
          .body = std::vector{bars, circle, rates},
          .legend = {{"bars", {.form = Form::bars, .tone = Tone::blue}},
                     {"circle", {.tone = Tone::green}},
                     {"dashes", {.dash = Dash::long_dashes}},
                     {"good", {.form = Form::band, .tone = Tone::good}}}};
}

// A row's name is above its fields on a narrow sheet.
inline Figure grid_figure() {
  Grid grid{.rows = {"comes to rest", "window-grows-under-the-sprite"},
            .columns = {16, {"stays-inside", Tone::ink}},
            .cells = {{.tone = Tone::good, .text = "25"},
                      {.column = 15, .tone = Tone::good, .text = "7", .right = 0.5},
                      {.column = 15, .tone = Tone::bad, .text = "17", .left = 0.5},
                      {.row = 1, .tone = Tone::notable, .text = "a text without room"},
                      {.row = 1, .column = 1}}};
  grid.columns[0].first = "calm";
  grid.columns[1] = {"wild", Tone::vermilion};
  return {.title = "Grid", .note = "all hold", .note_tone = Tone::green, .body = std::move(grid)};
}

}  // namespace hyrax
