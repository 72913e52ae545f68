// Pictures, compared with approved ones to the last line of their SVG; results as their page shows them;
// scales.
#include <gtest/gtest.h>

#include <regex>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/stored_run.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/report/picture_faults.h"
#include "tests/unit/tools/report/some_figures.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/report/figure_svg.h"
#include "tools/report/page_file.h"
#include "tools/report/plot_scale.h"
#include "tools/report/result_page.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

const std::string kPictures = "tests/unit/tools/report/pictures/";

void expect_picture(const std::string& name, const std::string& svg) {
  EXPECT_EQ(picture_faults(svg), std::vector<std::string>{}) << name;
  expect_approved(kPictures + name, svg);
}

// The texts and boxes of the narrowest sheet, and where the plots of all are, on which axes: the code that
// draws lines within these draws the SVG file, too.
std::string boxes_and_places(const std::string& html) {
  const std::size_t wider = html.find("<svg class=\"medium\"");
  const std::regex of_narrow("<(svg|text|rect) .*\n"), of_all("(<svg |<style>).*\n");
  std::string text;
  for (const auto& [part, kept] : {std::pair(html.substr(0, wider), of_narrow), {html.substr(wider), of_all}})
    for (std::sregex_iterator line(part.begin(), part.end(), kept), end; line != end; ++line)
      text += line->str();
  return text;
}

TEST(Pictures, OfFiguresAreThoseApproved) {
  for (const auto& [name, figure] : {std::pair(std::string("stacked"), stacked_figure()),
                                     {"beside", beside_figure()},
                                     {"grid", grid_figure()}}) {
    expect_picture(name + ".svg", figure_svg(figure));
    const std::string html = figure_html(figure);
    EXPECT_EQ(picture_faults(html), std::vector<std::string>{}) << name;
    expect_approved(kPictures + name + ".html", boxes_and_places(html));
  }
}

// A curve's name that goes into the legend leaves the ends of axes that give the plot its height.
TEST(Pictures, OfEqualScalesHaveTheirProportionsAtEveryWidth) {
  Plot plot{.x = {.low = 0, .high = 100},
            .y = {.low = 0, .high = 50},
            .series = {{.name = "path", .x = {0, 100}, .y = {0, 50}}},
            .texts = {{100, 50, "path"}},
            .has_equal_scales = true};
  const Figure named{.body = std::vector{plot}};
  EXPECT_EQ(figure_html(named).find("nan"), std::string::npos);
  plot.x.high = kNotGiven;
  EXPECT_EQ(figure_html({.body = std::vector{plot}}).find("nan"), std::string::npos)
      << "one end is not given";
}

// Of runs with all kinds of inputs, of which one lacks some rows, of one that becomes non-finite, one with a
// logarithmic scale of speeds, and ones in windows much longer than wide, and larger and smaller than any
// picture.
TEST(Pictures, OfRunsAreThoseApproved) {
  const std::string path = HYRAX_SOURCE_DIR "/tests/unit/tools/report/pictures/runs.json";
  const Json listed = parse_json(read_text_file(path), path);
  for (const Json& each : *listed.get<Json::Array>()) {
    const Scenario scenario = to_scenario(each, path, "");
    RunRecorder recorder(step_count(scenario));
    static_cast<void>(replay(shipped_core(), scenario, recorder));
    StoredRun run = recorder.take();
    if (scenario.name == "not-finite") run.rows.vx_px_per_s.back() = run.rows.x_px.back() = kNotGiven;
    Columns rows;
    for (std::size_t row = 0; row < run.rows.size(); ++row)
      if (scenario.name != "thrown-twice" || row < 60 || row > 75) rows.append(run.rows.row(row));
    const std::string svg = run_svg(scenario, rows, run.contacts);
    if (scenario.events.size() < 6)  // The names of more inputs may overlap.
      expect_picture(scenario.name + ".svg", svg);
    else
      expect_approved(kPictures + scenario.name + ".svg", svg);
  }
}

TEST(ResultPage, OfResultsIsTheOneApproved) {
  const Table table{"numbers",
                    "some <table>",
                    {{"n_of", "px2/s2", "a \"count\"", std::vector<std::int64_t>{1, -20, 3}},
                     {"x", "", "", std::vector<double>{0.5, kNotGiven, 1.0}},
                     {"is", "", "", std::vector<bool>{true, false, true}},
                     {"", "", "", std::vector<std::string>{"a", "<b>", "c"}}}};
  const ShownResult bad{.title = "<b> & more",
                        .subtitle = "what it is",
                        .verdict = {.answer = "not again",
                                    .text = {"first\n  line", "\n  before", table, table, "last"},
                                    .broken = {"one <rule>", "another"}},
                        .judgement = "not shown",
                        .tables = {table, {"many", "rows", {{"i", "", "", std::vector<double>(501, 7.0)}}}},
                        .figures = {{.title = "figure & <co>",
                                     .subtitle = "<of> it",
                                     .note = "a note",
                                     .remarks = {"a remark"}},
                                    {.title = "folded"}},
                        .origin = {{"core", "<paper>"}}};
  const TempFolder folder;
  const std::string path = folder.at("page.html");
  write_result_page(
      path, "study <a>",
      {bad, {.title = "good", .verdict = {.broken = {"one"}}}, {.title = "bare", .judgement = "all hold"}});
  std::string page = read_text_file(path);
  EXPECT_EQ(page.find("<script"), page.rfind("<script")) << "the one of pictures";
  EXPECT_NE(page.find(".findings"), std::string::npos) << "the style of results";
  page = std::regex_replace(page, std::regex("<style>[^]*?</style>|<script>[^]*?</script>|(<tr><td>7\n)+"),
                            "...");
  write_result_page(path, "report b.h5", {{.title = "swept", .members = Json::Object{}}, {.title = "other"}});
  page += "\n" + read_text_file(path);
  expect_approved(kPictures + "results.txt",
                  std::regex_replace(page, std::regex("hyrax-sim [0-9.]+"), "hyrax-sim VERSION"));
}

TEST(FigureHtml, SaysWhereValuesAreAndWhetherItHasRows) {
  Figure figure;
  figure.body = std::vector<Plot>{{.x = {.label = "\"t\", s", .low = 0, .high = 10},
                                   .y = {.label = "px", .is_logarithmic = true, .low = 0.1, .high = 1000},
                                   .series = {{.name = "a", .x = {0, 10}, .y = {0.1, 1000}}}}};
  const std::string html = figure_html(figure);
  std::smatch found;
  ASSERT_TRUE(std::regex_search(html, found,
                                std::regex("data-x=\"even\\|(\\S+) (\\S+) 0 10\\|&quot;t&quot;, s\" "
                                           "data-y=\"log\\|(\\S+) (\\S+) 0.1 1000\\|px\"")));
  std::smatch line;
  ASSERT_TRUE(
      std::regex_search(html, line, std::regex("series=\"a\">[^]*?d=\"M(\\S+),(\\S+) (\\S+),(\\S+)\"")));
  for (const auto& [end, place] : {std::pair<std::size_t, std::size_t>(1, 1), {3, 2}, {2, 3}, {4, 4}})
    EXPECT_NEAR(std::stod(line.str(place)), std::stod(found.str(end)), 0.03)
        << "its line goes from one end of the axes to the other";
  EXPECT_EQ(html.find("data-rows"), html.npos);
  figure.row_count = 2;
  EXPECT_NE(figure_html(figure).find("<div class=\"picture\" data-rows=\"2\">"), html.npos);
}

PlotScale scale_of(const Axis& axis, const std::vector<double>& values, double length_px = 400.0) {
  PlotScale scale(axis, values);
  scale.place(0.0, length_px, 80.0);
  return scale;
}

std::string ticks_of(const Axis& axis, const std::vector<double>& values, double length_px = 400.0) {
  std::string texts;
  for (const Tick& tick : scale_of(axis, values, length_px).ticks()) texts += " " + tick.text;
  return texts;
}

TEST(PlotScale, TicksAreRoundDistinctAndWithinTheEnds) {
  EXPECT_EQ(ticks_of({.low = 0.0, .high = 11'000.0}, {}), " 0 5,000 10,000");
  EXPECT_EQ(ticks_of({.low = 0.5996, .high = 0.6004, .decimals = 2}, {}),
            " 0.5996 0.5998 0.6000 0.6002 0.6004")
      << "more decimals than asked for, or two were the same";
  EXPECT_EQ(ticks_of({.low = -3.0, .high = 3.0}, {}), " −2 0 2");
  EXPECT_EQ(ticks_of({.low = 5.31, .high = 5.47}, {}, 180.0), " 5.35 5.40 5.45") << "one gives no scale";
  const Axis powers{.is_logarithmic = true};
  EXPECT_EQ(ticks_of(powers, {2.0, 8.0}, 300.0), " 2 5 10");
  EXPECT_EQ(ticks_of(powers, {1e-9, 1e5}, 700.0), " 10⁻⁸ 10⁻⁶ 10⁻⁴ 0.01 1 100 10,000");
  EXPECT_EQ(ticks_of(powers, {}, 300.0), " 1 10") << "no data";
  EXPECT_EQ(ticks_of({}, {7.0}, 200.0), " 5 10") << "one value";
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
  EXPECT_EQ(ticks_of(axis, {0.0, 1.0}), " 0 0.001 0.01 0.1 1");
  EXPECT_EQ(ticks_of(axis, {0.05, 1.0}), " 0.1 1") << "no data is 0";
  const Axis rounding{.is_logarithmic = true, .zero_at = 0.1, .zero_text = "≤ 0.1"};
  EXPECT_TRUE(ticks_of(rounding, {1e-14, 100.0}).starts_with(" ≤ 0.1 "));
  EXPECT_EQ(scale_of(rounding, {1e-14, 100.0}).at(1e-14), scale_of(rounding, {1e-14, 100.0}).at(0.1));
}

TEST(PlotScale, EqualScalesLeaveAnAxisWhoseEndsAreGiven) {
  const Axis axis, given{.low = 0.0, .high = 10.0};
  PlotScale fixed = scale_of(given, {}), y = scale_of(axis, {0.0, 10.0}, 100.0);
  PlotScale::make_equal(fixed, y);
  EXPECT_EQ(fixed.at(10.0), 400.0);
}

TEST(PlotScale, AStripTakesTheDataFarBelowTheRest) {
  const Axis axis{.is_logarithmic = true, .strip_below = 1e-8};
  EXPECT_TRUE(scale_of(axis, {1e-9, 1.01e-7, 1.0}).end_of_strip());
  EXPECT_FALSE(scale_of(axis, {1.0, 10.0}).end_of_strip());
  EXPECT_FALSE(scale_of(axis, {1e-9, 1e-7, 1.0}).end_of_strip()) << "nothing is empty between them";
  EXPECT_FALSE(scale_of(axis, {1e-10, 1e-9}).end_of_strip()) << "there is no rest";
}

// Each fault is found in a picture that has it.
TEST(PictureFaults, FindsOverlapsCutTextsAndPaleOnes) {
  const auto fault = [](const SvgPoint& at, const std::string& text, Tone tone = Tone::ink) {
    Sheet sheet{200, 100};
    sheet.svg.text({20, 20}, "one", {});
    sheet.svg.text(at, text, {.tone = tone});
    const std::vector<std::string> faults = picture_faults(svg_text("t", sheet));
    return faults.empty() ? "" : faults.front();
  };
  EXPECT_EQ(fault({20, 50}, "two"), "");
  EXPECT_EQ(fault({25, 24}, "two"), "overlap: one and two");
  EXPECT_EQ(fault({180, 20}, "long text"), "cut: long text");
  EXPECT_EQ(fault({20, 50}, "pale", Tone::hairline), "pale: pale");
  EXPECT_EQ(picture_faults("<svg><style>svg{height:auto}</style></svg>").size(), 1u);
  const Series one{.name = "a", .x = {1}, .y = {1}};
  EXPECT_EQ(shared_looks({one, one}).size(), 1u);
}

}  // namespace

// Replaces the page templates, which an everyday build lacks.
std::string_view page_template(PageKind kind) {
  switch (kind) {
    case PageKind::runs:
      return "runs";
    case PageKind::sweeps:
      return "sweeps\n<!--without JavaScript-->\n{\"hyrax\":\"report data\"}";
  }
  return {};
}

}  // namespace hyrax
