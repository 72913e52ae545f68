// Figures made by hand, as SVG.
#include "tools/report/figure_svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>

#include "tests/unit/tools/report/picture_faults.h"
#include "tools/report/figure_body.h"
#include "tools/report/look.h"
#include "tools/report/plot_scale.h"

namespace hyrax {
namespace {

bool has(const std::string& svg, const std::string& part) { return svg.find(part) != svg.npos; }

std::string svg_of(Plot plot) { return figure_svg({.title = "t", .body = std::vector{std::move(plot)}}); }

// The parts of lines of that colour, each from its own M.
std::vector<std::string> lines_of_colour(const std::string& svg, Tone tone) {
  std::vector<std::string> lines;
  const std::regex path("<path d=\"(M[^\"]*)\" fill=\"none\" stroke=\"" + colour_of(tone) + "\"");
  for (std::sregex_iterator found(svg.begin(), svg.end(), path), end; found != end; ++found)
    lines.push_back((*found)[1]);
  return lines;
}

std::vector<std::string> texts_of(const PlotScale& scale) {
  std::vector<std::string> texts;
  for (const Tick& tick : scale.ticks()) texts.push_back(tick.text);
  return texts;
}

PlotScale scale_of(const Axis& axis, const std::vector<double>& values, double length_px = 400.0) {
  PlotScale scale(axis, values);
  scale.place(0.0, length_px, 80.0);
  return scale;
}

TEST(PlotScale, TicksAreRoundDistinctAndWithinTheEnds) {
  const Axis thousands{.low = 0.0, .high = 11'000.0};
  EXPECT_EQ(texts_of(scale_of(thousands, {})), (std::vector<std::string>{"0", "5,000", "10,000"}));
  const Axis close{.low = 0.5996, .high = 0.6004, .decimals = 2};
  EXPECT_EQ(texts_of(scale_of(close, {})),
            (std::vector<std::string>{"0.5996", "0.5998", "0.6000", "0.6002", "0.6004"}))
      << "more decimals than asked for, or two were the same";
  const Axis signs{.low = -3.0, .high = 3.0};
  EXPECT_EQ(texts_of(scale_of(signs, {})), (std::vector<std::string>{"−2", "0", "2"}));
  const Axis short_of_two{.low = 5.31, .high = 5.47};
  EXPECT_EQ(texts_of(scale_of(short_of_two, {}, 180.0)), (std::vector<std::string>{"5.35", "5.40", "5.45"}))
      << "a single tick gives no scale";
}

TEST(PlotScale, TicksEndWhereNumbersAreFarApart) {
  const Axis huge{.low = 1e19, .high = 1e19 + 4096.0};
  const std::vector<Tick> ticks = scale_of(huge, {}).ticks();
  EXPECT_GE(ticks.size(), 2u);
  EXPECT_LE(ticks.size(), 6u);
  for (std::size_t index = 1; index < ticks.size(); ++index) EXPECT_LT(ticks[index - 1].at, ticks[index].at);
}

TEST(PlotScale, ZeroHasATickOnALogarithmicAxisWhereThereIsOneAndNoneBelow) {
  const Axis axis{.is_logarithmic = true, .zero_at = 1e-4};
  EXPECT_EQ(texts_of(scale_of(axis, {0.0, 1.0})),
            (std::vector<std::string>{"0", "0.001", "0.01", "0.1", "1"}));
  EXPECT_EQ(texts_of(scale_of(axis, {0.05, 1.0})), (std::vector<std::string>{"0.1", "1"})) << "no data is 0";
  const Axis rounding{.is_logarithmic = true, .zero_at = 0.1, .zero_text = "≤ 0.1"};
  EXPECT_EQ(texts_of(scale_of(rounding, {1e-14, 100.0})).front(), "≤ 0.1");
  EXPECT_EQ(scale_of(rounding, {1e-14, 100.0}).at(1e-14), scale_of(rounding, {1e-14, 100.0}).at(0.1));
}

TEST(PlotScale, AReversedAxisHasItsLowEndWhereOthersHaveTheHigh) {
  EXPECT_EQ(scale_of({.low = 0.0, .high = 10.0}, {}).at(10.0), 400.0);
  EXPECT_EQ(scale_of({.is_reversed = true, .low = 0.0, .high = 10.0}, {}).at(0.0), 400.0);
  EXPECT_EQ(scale_of({.is_reversed = true, .low = 0.0, .high = 10.0}, {}).at(10.0), 0.0);
}

TEST(PlotScale, EqualScalesWidenTheAxisThatIsTooLong) {
  const Axis axis;
  PlotScale x = scale_of(axis, {0.0, 10.0}), y = scale_of(axis, {0.0, 10.0}, 100.0);
  PlotScale::make_equal(x, y);
  EXPECT_NEAR(x.at(1.0) - x.at(0.0), y.at(1.0) - y.at(0.0), 1e-9);
  EXPECT_NEAR(y.at(10.0) - y.at(0.0), 100.0 / 1.1, 1e-9) << "the other stays";
  EXPECT_NEAR(x.at(5.0), 200.0, 1e-9) << "to both sides";
}

TEST(PlotScale, AStripTakesTheDataFarBelowTheRest) {
  const Axis axis{.is_logarithmic = true, .strip_below = 1e-8};
  const PlotScale scale = scale_of(axis, {1e-12, 1e-11, 1.0, 10.0});
  ASSERT_TRUE(scale.gap());
  EXPECT_LT(scale.gap()->to_px, scale.gap()->from_px);
  EXPECT_LT(scale.at(1e-11), scale.gap()->to_px);
  EXPECT_GT(scale.at(1.0), scale.gap()->from_px);
  EXPECT_GT(scale.at(10.0) - scale.at(1.0), 0.4 * 400.0) << "one decade has most of the axis";
  for (const Tick& tick : scale.ticks()) EXPECT_TRUE(tick.at < 1e-10 || tick.at > 0.1) << tick.text;
  EXPECT_FALSE(scale_of(axis, {1.0, 10.0}).gap());
  EXPECT_FALSE(scale_of(axis, {1e-9, 1e-7, 1.0}).gap()) << "nothing is empty between them";
}

TEST(PlotScale, APowerOfTenIsWrittenAsPeopleDo) {
  EXPECT_EQ(power_of_ten(6), "10⁶");
  EXPECT_EQ(power_of_ten(-12), "10⁻¹²");
  EXPECT_EQ(power_of_ten(0), "10⁰");
}

TEST(PlotSvg, AMissingValueIsAGapInTheLine) {
  const Series series{
      .look = {.tone = Tone::blue}, .x = {1.0, 2.0, 3.0, 4.0}, .y = {1.0, std::nan(""), 3.0, 4.0}};
  const std::vector<std::string> lines = lines_of_colour(svg_of({.series = {series}}), Tone::blue);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(std::count(lines[0].begin(), lines[0].end(), 'M'), 2);
}

TEST(PlotSvg, SpreadIsDrawnAsBarsThroughThePoints) {
  Plot plot{
      .series = {{.look = {.form = Form::points, .tone = Tone::blue}, .x = {1.0, 2.0}, .y = {3.0, 4.0}}}};
  EXPECT_TRUE(lines_of_colour(svg_of(plot), Tone::blue).empty());
  plot.series[0].x_low = {0.5, 1.5};
  plot.series[0].x_high = {1.25, 2.75};
  std::vector<double> lengths;
  for (const std::string& line : lines_of_colour(svg_of(plot), Tone::blue)) {
    std::smatch ends;
    ASSERT_TRUE(std::regex_match(line, ends, std::regex(R"(M([\d.]+)[ ,][\d.]+ ?L?([\d.]+)[ ,][\d.]+)")))
        << line;
    lengths.push_back(std::stod(ends[2]) - std::stod(ends[1]));
  }
  ASSERT_EQ(lengths.size(), 2u);
  EXPECT_NEAR(lengths[1] / lengths[0], 1.25 / 0.75, 0.02) << "from the low to the high end";
}

TEST(PlotSvg, TextsKeepOffCurvesAndOneAnother) {
  Plot plot{.x = {.low = 0.0, .high = 10.0},
            .y = {.low = 0.0, .high = 10.0},
            .texts = {{5.0, 5.0, "first"}, {5.0, 5.0, "second"}}};
  plot.series = {{.x = {5.0}, .y = {5.0}}};
  const std::string free = svg_of(plot);
  EXPECT_GT(place_of(free, "first").x, place_of(free, "second").x) << "the right of the point is taken";
  plot.series = {{.x = {5.0, 9.0}, .y = {5.0, 5.0}}};
  EXPECT_LT(place_of(svg_of(plot), "first").x, place_of(free, "first").x) << "a curve goes to the right";
}

TEST(PlotSvg, ALineLeadsToALabelThatIsNotBesideItsPoint) {
  Plot plot{.x = {.low = 0.0, .high = 10.0},
            .y = {.low = 0.0, .high = 10.0},
            .series = {{.x = {5.0}, .y = {5.0}}},
            .texts = {{5.0, 5.0, "first"}}};
  EXPECT_TRUE(lines_of_colour(svg_of(plot), Tone::quiet).empty());
  plot.texts.resize(6, plot.texts.front());
  EXPECT_FALSE(lines_of_colour(svg_of(plot), Tone::quiet).empty())
      << "right, left, above and below are taken";
}

TEST(PlotSvg, PlotsAreSideBySideWhereThereIsRoom) {
  const Plot plot{.y = {.label = "first"}, .series = {{.x = {1.0, 2.0}, .y = {1.0, 2.0}}}};
  Plot other = plot;
  other.y.label = "other";
  const std::string html = figure_html({.title = "t", .body = std::vector{plot, other}});
  const std::size_t medium = html.find("class=\"medium\""), wide = html.find("class=\"wide\"");
  const auto is_below = [](const std::string& svg) {
    return place_of(svg, "other").y > place_of(svg, "first").y + 200.0;
  };
  EXPECT_TRUE(is_below(html.substr(0, medium)));
  EXPECT_TRUE(is_below(html.substr(medium, wide - medium)));
  EXPECT_FALSE(is_below(html.substr(wide)));
  EXPECT_EQ(picture_faults(html), std::vector<std::string>{});
}

TEST(PlotSvg, NamesOfCurvesAreBelowANarrowPlot) {
  const Plot plot{.x = {.label = "time, s", .low = 0.0, .high = 40.0},
                  .series = {{.name = "exact", .x = {1.0, 2.0}, .y = {1.0, 2.0}}},
                  .texts = {{2.0, 2.0, "exact: order 2.00"}}};
  const std::string html = figure_html({.title = "t", .body = std::vector{plot}});
  const std::size_t medium = html.find("class=\"medium\"");
  const std::string narrow = html.substr(0, medium), wider = html.substr(medium);
  EXPECT_GT(place_of(narrow, "exact: order 2.00").y, place_of(narrow, "time, s").y);
  EXPECT_LT(place_of(wider, "exact: order 2.00").y, place_of(wider, "time, s").y);
  EXPECT_FALSE(box_of(narrow, "30")) << "no room for names beside the curves";
  EXPECT_TRUE(box_of(wider, "30"));
}

TEST(PlotSvg, LongTextsAreBrokenOnANarrowSheet) {
  std::string text = "what";
  for (int word = 0; word < 12; ++word) text += " happens";
  const Plot empty{.when_empty = text}, drawn{.y = {.label = text}, .series = {{.x = {1.0}, .y = {1.0}}}};
  for (const Plot& plot : {empty, drawn}) {
    const std::string html = figure_html({.title = "t", .body = std::vector{plot}});
    EXPECT_EQ(picture_faults(html), std::vector<std::string>{});
    EXPECT_TRUE(box_of(html, text)) << "the wide one has room";
  }
}

TEST(PlotSvg, APlotWithoutPointsSaysWhyAndHasNoAxes) {
  const Plot drawn{.y = {.label = "distance, px"}, .series = {{.x = {1.0, 2.0}, .y = {1.0, 2.0}}}};
  const Plot empty{.y = {.label = "cost, ns"}, .when_empty = "not measured"};
  for (const std::vector<Plot>& plots : {std::vector{empty, drawn}, {drawn, empty}}) {
    const std::string svg = figure_svg({.title = "t", .body = plots});
    EXPECT_TRUE(has(svg, ">not measured</text>"));
    EXPECT_TRUE(has(svg, ">distance, px</text>"));
    EXPECT_FALSE(has(svg, "cost, ns"));
  }
  EXPECT_TRUE(has(figure_svg({.title = "t", .body = std::vector<Plot>{}}), "nothing to show"));
}

TEST(PlotSvg, PlotsOfOneXAxisAreBelowEachOtherAndTheirAxesAreAligned) {
  const auto plot = [](double y, double to) {
    return Plot{.x = {.low = 0.0, .high = to, .ticks = {{0.5, "half"}}},
                .y = {.low = 0.0, .high = y},
                .series = {{.look = {.tone = Tone::green}, .x = {0.0, 1.0}, .y = {0.0, y}}}};
  };
  const auto halves = [&](const std::vector<Plot>& plots) {
    std::vector<SvgPoint> places;
    for (const ShownText& shown : texts_in(figure_svg({.title = "t", .body = plots})))
      if (shown.text == "half") places.push_back(shown.box.centre());
    return places;
  };
  for (const auto& plots : {std::vector{plot(1.0, 1.0), plot(1e9, 1.0)}, {plot(1e9, 1.0), plot(1.0, 1.0)}}) {
    const std::vector<SvgPoint> stacked = halves(plots);
    ASSERT_EQ(stacked.size(), 2u);
    EXPECT_EQ(stacked[0].x, stacked[1].x);
    EXPECT_GT(stacked[1].y, stacked[0].y + 200.0);
  }
  const std::vector<SvgPoint> beside = halves({plot(1.0, 1.0), plot(1.0, 2.0)});
  ASSERT_EQ(beside.size(), 2u);
  EXPECT_GT(beside[1].x, beside[0].x + 200.0);
  EXPECT_EQ(beside[0].y, beside[1].y);
}

TEST(PlotSvg, BarsGoFromTheLowEndOfTheAxisInTheirColour) {
  Plot plot{.x = {.is_logarithmic = true, .low = 0.1, .high = 1000.0},
            .y = {.categories = {"gravity", "Runge-Kutta"}}};
  plot.series = {{.look = {.form = Form::bars, .tone = Tone::blue}, .x = {941.0}, .y = {0.0}},
                 {.look = {.form = Form::bars, .tone = Tone::orange}, .x = {1e-3}, .y = {1.0}}};
  plot.texts = {{1e-3, 1.0, "below"}};
  const std::string svg = svg_of(plot);
  const SvgBox blue = rectangle_of(svg, colour_of(Tone::blue)),
               orange = rectangle_of(svg, colour_of(Tone::orange));
  EXPECT_EQ(blue.left, orange.left);
  EXPECT_GT(blue.width(), 700.0);
  EXPECT_EQ(orange.width(), 0.0) << "no bar left of the axis";
  EXPECT_GT(box_of(svg, "below")->left, orange.left) << "no label left of the axis";
  EXPECT_LT(blue.top, orange.top) << "the first category is on top";
  EXPECT_TRUE(has(svg, ">Runge-Kutta</text>")) << "a hyphen is no minus";
}

TEST(PlotSvg, ATextThatHasNoRoomBesideItsBarIsBelowIt) {
  Plot plot{.x = {.low = 0.0, .high = 10.0}, .y = {.categories = {"gravity"}}};
  plot.series = {{.look = {.form = Form::bars, .tone = Tone::blue}, .x = {8.0}, .y = {0.0}}};
  plot.texts = {{8.0, 0.0, "941 px, 11 contacts moved"}};
  const std::string html = figure_html({.title = "t", .body = std::vector{plot}});
  const SvgBox bar = rectangle_of(html, colour_of(Tone::blue));  // Of the narrow picture.
  const std::optional<SvgBox> text = box_of(html, plot.texts[0].text);
  ASSERT_TRUE(text);
  EXPECT_LT(text->left, bar.right) << "there was room beside it";
  EXPECT_GT(text->top, bar.bottom);
}

TEST(PlotSvg, ABandIsTheAreaBetweenItsEnds) {
  Plot plot{.x = {.low = 0, .high = 10}, .y = {.low = 0, .high = 10}};
  plot.series = {
      {.look = {.form = Form::band, .tone = Tone::blue}, .x = {1, 2, 2}, .y = {5, 5, 7}, .y_low = {0, 0, 3}}};
  std::smatch found;
  const std::string svg = svg_of(plot);
  ASSERT_TRUE(std::regex_search(svg, found,
                                std::regex("<path d=\"M([^\"]*)Z\" fill=\"" + colour_of(Tone::blue) + "\"")));
  const std::string corners = found[1];
  EXPECT_EQ(std::count(corners.begin(), corners.end(), ','), 6);
}

TEST(PlotSvg, MarksInAnyOrderAreLabelledFromLeftToRight) {
  Plot plot{.x = {.low = 0.0, .high = 100.0},
            .y = {.low = 0.0, .high = 100.0},
            .series = {{.x = {1.0}, .y = {1.0}}},
            .marks = {{.at = 40.0, .text = "at forty"}, {.at = 41.0, .text = "a little after"}}};
  const std::string svg = svg_of(plot);
  EXPECT_NEAR(place_of(svg, "at forty").x, place_of(svg, "40").x, 0.1);
  EXPECT_GT(box_of(svg, "a little after").value_or(SvgBox{}).left,
            box_of(svg, "at forty").value_or(SvgBox{}).right);
  std::ranges::reverse(plot.marks);
  EXPECT_EQ(svg_of(plot), svg);
}

TEST(PlotSvg, APointHasItsNameForThePointer) {
  Plot plot{.series = {{.name = "Verlet",
                        .look = {.form = Form::points},
                        .x = {1.0},
                        .y = {1.0},
                        .point_names = {"60 Hz"}}}};
  plot.x.label = "cost, ns";
  plot.y.categories = {"a", "b"};
  EXPECT_TRUE(has(svg_of(plot), "<title>Verlet, 60 Hz; cost, ns: 1; b</title>"));
}

TEST(Legend, IsARowIfItFitsAndElseLines) {
  Figure figure{.title = "t", .body = std::vector<Plot>{{.series = {{.x = {1.0}, .y = {1.0}}}}}};
  figure.legend = {{"one", {}}, {"two", {}}, {"three", {}}};
  const std::string row = figure_svg(figure);
  EXPECT_EQ(place_of(row, "one").y, place_of(row, "three").y);
  const std::string long_end(60, '.');
  for (LegendEntry& entry : figure.legend) entry.text += long_end;
  const std::string lines = figure_svg(figure);
  EXPECT_LT(place_of(lines, "one" + long_end).y, place_of(lines, "three" + long_end).y);
  EXPECT_TRUE(picture_faults(lines).empty());
}

TEST(GridSvg, APartOfAFieldHasItsColourAndText) {
  Grid grid{.rows = {"rest"}, .columns = {{"comes-to-rest", Tone::ink}}};
  grid.cells = {{0, 0, Tone::good, "7", 0.0, 0.5}, {0, 0, Tone::bad, "17", 0.5, 1.0}};
  const std::string svg = figure_svg({.title = "Grid", .body = grid});
  for (const std::string& part : {"fill=\"" + colour_of(Tone::good), "fill=\"" + colour_of(Tone::bad),
                                  std::string(">7<"), std::string(">17<")})
    EXPECT_TRUE(has(svg, part)) << part;
  EXPECT_FALSE(has(svg, colour_of(Tone::notable)));
}

TEST(GridSvg, ARowsNameIsAboveItsFieldsOnANarrowSheet) {
  Grid grid{.rows = {"window-grows-under-the-sprite"},
            .columns = std::vector(16, std::pair(std::string("comes-to-rest"), Tone::ink))};
  grid.cells = {
      {0, 0, Tone::good, "25"}, {0, 15, Tone::good, "7", 0.0, 0.5}, {0, 15, Tone::bad, "17", 0.5, 1.0}};
  const std::string html = figure_html({.title = "Grid", .body = grid});
  const std::size_t medium = html.find("class=\"medium\""), wide = html.find("class=\"wide\"");
  const auto rise = [&](const std::string& svg) {
    return place_of(svg, "25").y - place_of(svg, grid.rows[0]).y;
  };
  EXPECT_GT(rise(html.substr(0, medium)), 15.0);
  EXPECT_EQ(rise(html.substr(medium, wide - medium)), 0.0);
  EXPECT_FALSE(has(html.substr(0, medium), ">17<")) << "wider than its field";
  EXPECT_TRUE(has(html.substr(wide), ">17<"));
  EXPECT_EQ(picture_faults(html), std::vector<std::string>{});
}

TEST(ListingHtml, IsATableThatWrapsWithItsColours) {
  const Listing listing{.columns = {{.title = "section"}, {.title = "measured", .is_right = true}},
                        .rows = {{{"<3>", "a detail", Tone::bad}, {"0.6"}}}};
  EXPECT_EQ(
      figure_html({.title = "t", .body = listing}),
      "<div class=\"picture\">\n<table "
      "class=\"listing\">\n<thead><tr><th>section</th><th>measured</th></tr></thead>\n"
      "<tbody>\n<tr><td><mark style=\"background:var(--fill-bad)\">&lt;3></mark><small>a detail</small></td>"
      "<td class=\"number\">0.6</td></tr>\n</tbody></table>\n</div>\n");
}

TEST(FigureSvg, HasADarkPictureOfTheSameColoursAsThePage) {
  const std::string svg =
      svg_of({.series = {{.look = {.tone = Tone::blue}, .x = {1.0, 2.0}, .y = {1.0, 2.0}}}});
  const std::string blue = colour_of(Tone::blue);
  EXPECT_TRUE(has(svg, "[stroke=\"" + blue + "\"]{stroke:" + dark_of(blue) + "}"));
  EXPECT_TRUE(
      has(svg, "[fill=\"" + colour_named("card") + "\"]{fill:" + dark_of(colour_named("card")) + "}"));
  EXPECT_NE(dark_of(blue), blue);
}

TEST(FigureSvg, AnAwkwardTextStaysText) {
  const std::string svg = figure_svg({.title = "it's <b> & \"q\"\n\\", .body = std::vector<Plot>{}});
  EXPECT_TRUE(has(svg, "<title>it's &lt;b> &amp; &quot;q&quot; \\</title>"));
}

TEST(Look, TextHasContrastAndSeriesDiffer) {
  for (const Tone tone : {Tone::ink, Tone::quiet, Tone::vermilion, Tone::orange, Tone::blue, Tone::green,
                          Tone::purple, Tone::sky_blue, Tone::lavender}) {
    const std::string colour = colour_of(tone), card = colour_named("card");
    EXPECT_GE(contrast_of(colour, card), 4.5) << name_of(tone);
    EXPECT_GE(contrast_of(dark_of(colour), dark_of(card)), 4.5) << name_of(tone);
  }
  EXPECT_LT(contrast_of(colour_of(Tone::hairline), colour_named("card")), 4.5) << "a colour that is too pale";
}

// Each fault is found in a picture that has it.
TEST(PictureFaults, FindsOverlapsCutTextsAndPaleOnes) {
  const auto faults_of = [](const auto& draw) {
    Sheet sheet{200, 100};
    draw(sheet.svg);
    return picture_faults(svg_text("t", sheet));
  };
  const Lettering letters{.tone = Tone::ink};
  EXPECT_TRUE(faults_of([&](Svg& svg) {
                svg.text({20, 20}, "one", letters), svg.text({20, 50}, "two", letters);
              }).empty());
  EXPECT_EQ(faults_of([&](Svg& svg) {
              svg.text({20, 20}, "one", letters), svg.text({25, 24}, "two", letters);
            }),
            std::vector<std::string>{"overlap: one and two"});
  EXPECT_EQ(faults_of([&](Svg& svg) {
              svg.text({180, 20}, "long text", letters);
            }),
            std::vector<std::string>{"cut: long text"});
  EXPECT_EQ(faults_of([&](Svg& svg) {
              svg.text({20, 20}, "pale", {.tone = Tone::hairline});
            }).front(),
            "pale: pale");
  EXPECT_EQ(picture_faults("<svg><style>svg{height:auto}</style></svg>").size(), 1u);
  const Series one{.name = "a", .x = {1}, .y = {1}};
  EXPECT_EQ(shared_looks({one, one}).size(), 1u);
}

// Viridis, of which the darkest third is left out on a dark page, and the lightest on a light one.
TEST(Look, SpeedsHaveColoursThatStandOutOnTheirPage) {
  const auto on_dark = [](double part) {
    return std::ranges::find(light_and_dark(), speed_colour(part),
                             &std::pair<std::string, std::string>::first)
        ->second;
  };
  EXPECT_EQ(speed_colour(0.0), "#440154");
  EXPECT_EQ(on_dark(0.0), "#31688e");
  EXPECT_EQ(speed_colour(1.0), "#35b779");
  EXPECT_EQ(on_dark(1.0), "#fde725");
}

}  // namespace
}  // namespace hyrax
