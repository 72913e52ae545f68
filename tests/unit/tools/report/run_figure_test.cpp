#include "tools/report/run_figure.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <regex>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <unistd.h>

#include "tools/files/failure.h"
#include "tools/files/text_file.h"
#include "tools/report/figure_script.h"
#include "tools/report/figure_style.h"
#include "tools/report/gnuplot.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

constexpr std::size_t kSvgBytesMax = 200'000;

Scenario some_fling() {
  Scenario scenario;
  scenario.name = "some-fling";
  scenario.window = {1920, 1080};
  scenario.sprite = {128, 128};
  scenario.start = {60, 900};
  scenario.start_velocity = {1000, -1350};
  scenario.clock.base = FixedRate{60};
  scenario.length = std::int64_t{600};
  return scenario;
}

// Back and forth through the window on a wave, ever faster and slower: no two rows have the same
// colour, so that no picture is larger.
Columns colourful_rows(std::int64_t count) {
  Columns rows;
  for (std::int64_t i = 0; i < count; ++i) {
    const double t_s = static_cast<double>(i) / 60;
    rows.append({i, t_s, 1.0 / 60, 896 + 896 * std::sin(1.3 * t_s), 476 + 476 * std::sin(1.7 * t_s), 3000.0,
                 (i % 2 == 0 ? 1.0 : 0.1) * static_cast<double>(i % 40) * 100, 0});
  }
  return rows;
}

std::vector<Contact> contacts_at_each_wall(std::int64_t count) {
  std::vector<Contact> contacts;
  for (std::int64_t i = 0; i < count; ++i) {
    Contact contact;
    contact.step = contact.last_step = i + 1;
    contact.wall = kWalls[static_cast<std::size_t>(i) % 4];
    contact.x_px = static_cast<double>(i * 59 % 1792);
    contact.y_px = static_cast<double>(i * 31 % 952);
    contacts.push_back(contact);
  }
  return contacts;
}

double number_after(const std::string& script, const std::string& text) {
  const std::size_t at = script.find(text);
  EXPECT_NE(at, std::string::npos) << text;
  return std::stod(script.substr(at + text.size()));
}

// The points of a data block, and the broken lines between them.
std::size_t lines_in_block(const std::string& script, const std::string& name) {
  const std::size_t begin = script.find("$" + name + " << EOD\n");
  const std::string block = script.substr(begin, script.find("EOD\n", script.find('\n', begin)) - begin);
  std::size_t lines = 0;
  std::istringstream stream(block);
  for (std::string line; std::getline(stream, line);) lines += !line.empty() && line.front() != '$';
  return lines;
}

// Every opened tag is closed, in order, and the text has no stray `<` or `&`.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    at = end;
    if (tag.find('<') != std::string::npos) return false;
    if (tag.front() == '?' || tag.front() == '!' || tag.back() == '/') continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \n\t"));
    if (name.front() != '/') {
      open.push_back(name);
    } else {
      if (open.empty() || "/" + open.back() != name) return false;
      open.pop_back();
    }
  }
  for (std::size_t at = xml.find('&'); at != std::string::npos; at = xml.find('&', at + 1))
    if (const std::size_t end = xml.find(';', at); end == std::string::npos || end - at > 6) return false;
  return open.empty();
}

class RunFigureTest : public testing::Test {
 protected:
  RunFigureTest() {
    std::string name = (std::filesystem::temp_directory_path() / "hyrax-figure-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~RunFigureTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::size_t files() const {
    const std::filesystem::directory_iterator entries(folder_);
    return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
  }
  static bool has_gnuplot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

 private:
  std::filesystem::path folder_;
};

// gnuplot is optional for users and required in CI.
#define SKIP_WITHOUT_GNUPLOT()                                           \
  if (!has_gnuplot()) {                                                  \
    ASSERT_EQ(std::getenv("CI"), nullptr) << "gnuplot is not installed"; \
    GTEST_SKIP() << "gnuplot is not installed";                          \
  }                                                                      \
  static_assert(true)

TEST_F(RunFigureTest, DrawsTheWindowToScale) {
  const std::string script = run_figure_script(some_fling(), colourful_rows(100), {});
  EXPECT_NE(script.find("$window << EOD\n0 0\n1920 0\n1920 1080\n0 1080\n0 0\n"), std::string::npos);

  const double width = number_after(script, "set terminal svg size ");
  const double height = number_after(script, "svg size " + std::to_string(static_cast<int>(width)) + ",");
  const double plot_width =
      width * (number_after(script, "rmargin at screen ") - number_after(script, "lmargin at screen "));
  const double plot_height =
      height * (number_after(script, "tmargin at screen ") - number_after(script, "bmargin at screen "));
  std::istringstream xrange(script.substr(script.find("set xrange [") + 12));
  std::istringstream yrange(script.substr(script.find("set yrange [") + 12));
  double left = 0, right = 0, bottom = 0, top = 0;
  char colon = 0;
  xrange >> left >> colon >> right;
  yrange >> bottom >> colon >> top;
  EXPECT_LT(top, bottom) << "y points down";
  EXPECT_NEAR(plot_width / (right - left), plot_height / (bottom - top), 1e-6);
}

TEST_F(RunFigureTest, TheSameRunGivesTheSameText) {
  EXPECT_EQ(run_figure_script(some_fling(), colourful_rows(1000), contacts_at_each_wall(20)),
            run_figure_script(some_fling(), colourful_rows(1000), contacts_at_each_wall(20)));
}

TEST_F(RunFigureTest, DrawsThePathOfTheCentre) {
  Columns rows;
  rows.append({0, 0.0, 0.0, 100, 200, 600, 0, 0});
  rows.append({1, 1.0 / 60, 1.0 / 60, 110, 200, 600, 0, 0});
  EXPECT_NE(run_figure_script(some_fling(), rows, {}).find("$flown << EOD\n164 264 600\n174 264 600\n"),
            std::string::npos);
}

TEST_F(RunFigureTest, AJumpIsNotDrawnAsFlight) {
  Columns rows;
  rows.append({0, 0.0, 0.0, 100, 200, 600, 0, 0});
  rows.append({1, 1.0 / 60, 1.0 / 60, 1100, 200, 600, 0, 0});
  const std::string script = run_figure_script(some_fling(), rows, {});
  EXPECT_EQ(lines_in_block(script, "moved"), 2u);
  EXPECT_NE(script.find("not flown"), std::string::npos);
}

TEST_F(RunFigureTest, TheWayBetweenRowsFarApartIsNotMadeUp) {
  Columns rows;
  rows.append({0, 0.0, 0.0, 100, 200, 600, 0, 0});
  rows.append({100, 100.0 / 60, 1.0 / 60, 1100, 200, 600, 0, 0});
  const std::string script = run_figure_script(some_fling(), rows, {});
  EXPECT_EQ(lines_in_block(script, "unrecorded"), 2u);
  EXPECT_NE(script.find("not recorded"), std::string::npos);
  EXPECT_NE(script.find("the first 100 of 600 steps"), std::string::npos);
}

TEST_F(RunFigureTest, TheLegendCountsContactsThatAreNotDrawn) {
  const std::string script = run_figure_script(some_fling(), colourful_rows(10), contacts_at_each_wall(4),
                                               WallCounts{5, 6, 7, 1'234'567});
  for (const std::string label : {"'left 5'", "'right 6'", "'top 7'", "'ground 1234567'"})
    EXPECT_NE(script.find(label), std::string::npos) << label;
}

TEST_F(RunFigureTest, ARunThatBecomesNonFiniteSaysSoAndMarksThePlace) {
  Columns rows = colourful_rows(100);
  const auto has_mark = [&] {
    const std::string script = run_figure_script(some_fling(), rows, {});
    const bool has_note = script.find("'vx is NaN from step 100 of 600 (1.67 s)'") != std::string::npos;
    const bool has_cross = script.find("$not_finite title") != std::string::npos;
    EXPECT_EQ(has_note, has_cross);
    EXPECT_EQ(has_cross, script.find("'not finite'") != std::string::npos);
    return has_cross;
  };
  EXPECT_FALSE(has_mark());
  rows.append({100, 100.0 / 60, 1.0 / 60, std::nan(""), 500.0, std::nan(""), 0.0, 0});
  EXPECT_TRUE(has_mark());
}

TEST_F(RunFigureTest, LeavesOutRowsThatAreNotFinite) {
  Columns rows = colourful_rows(100);
  rows.x_px[50] = std::numeric_limits<double>::quiet_NaN();
  rows.vy_px_per_s[51] = std::numeric_limits<double>::infinity();
  const std::string script = run_figure_script(some_fling(), rows, {});
  EXPECT_EQ(script.find("inf"), std::string::npos);
  EXPECT_EQ(script.find("\nnan"), std::string::npos);
}

TEST_F(RunFigureTest, APathHasNoMorePointsThanItsBound) {
  const std::string script = run_figure_script(some_fling(), colourful_rows(1'000'000), {});
  EXPECT_LE(lines_in_block(script, "flown"), kPathPointsMax + 1);
  EXPECT_NE(script.find("path drawn up to "), std::string::npos) << "and says what is missing";
}

TEST_F(RunFigureTest, AStartFarOutsideLeavesTheWindowLargeAndIsNoted) {
  Scenario scenario = some_fling();
  scenario.start = {-1'000'000, 1'000'000};
  Columns rows;
  rows.append({0, 0.0, 0.0, -1'000'000, 1'000'000, 0, 0, 0});
  rows.append({1, 1.0 / 60, 1.0 / 60, 0, 952, 0, 0, 9});
  scenario.length = std::int64_t{1};
  const std::string script = run_figure_script(scenario, rows, {});
  EXPECT_GT(number_after(script, "set xrange ["), -500);
  EXPECT_NE(script.find("starts far outside, at x -1000000, y 1000000 px"), std::string::npos);
}

TEST_F(RunFigureTest, AnAwkwardNameCannotLeaveItsQuotes) {
  Scenario scenario = some_fling();
  scenario.name = "it's\n! rm -rf";
  EXPECT_NE(run_figure_script(scenario, colourful_rows(10), {}).find("'it''s ! rm -rf'"), std::string::npos);
}

TEST_F(RunFigureTest, WritesWellFormedXml) {
  SKIP_WITHOUT_GNUPLOT();
  Scenario scenario = some_fling();
  scenario.name = "it's <b> & \"q\" {x}_y^z \\n $(ls) `ls`";
  draw_run_figure(path("a.svg"), scenario, colourful_rows(600), contacts_at_each_wall(9));
  const std::string svg = read_text_file(path("a.svg"));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_NE(svg.find("it's &lt;b>"), std::string::npos);
  EXPECT_NE(svg.find("<title>it's &lt;b> &amp; \"q\""), std::string::npos);
  EXPECT_NE(svg.find("{x}_y^z \\n $(ls) `ls`"), std::string::npos);
}

TEST_F(RunFigureTest, PictureAndSeriesHaveNamesForPeople) {
  SKIP_WITHOUT_GNUPLOT();
  draw_run_figure(path("a.svg"), some_fling(), colourful_rows(600), contacts_at_each_wall(9));
  const std::string svg = read_text_file(path("a.svg"));
  EXPECT_NE(svg.find("<title>some-fling</title>"), std::string::npos);
  EXPECT_NE(svg.find("<title>path of the centre</title>"), std::string::npos);
  EXPECT_GT(svg.rfind("<title>contacts: ground</title>"), svg.rfind("<title>contacts: top</title>"));
  EXPECT_EQ(svg.rfind("<title>contacts: ground</title>"), svg.rfind("<title>"));
  for (const std::string made_up : {"<title>Gnuplot", "<title>gnuplot_plot", "<title>$"})
    EXPECT_EQ(svg.find(made_up), std::string::npos) << made_up;
}

// The y of a label on the canvas, from its lower edge, as a part of its height.
double label_y(const std::string& script, const std::string& label) {
  const std::size_t at = script.find("set label '" + label + "' at screen ");
  EXPECT_NE(at, std::string::npos) << label;
  return std::stod(script.substr(script.find(',', at) + 1));
}

Columns dropped_rows(std::int64_t count) {
  Columns rows;
  for (std::int64_t i = 0; i < count; ++i)
    rows.append(
        {i, static_cast<double>(i) / 60, 1.0 / 60, 900, 100.0 + 10.0 * static_cast<double>(i), 0, 600, 0});
  return rows;
}

TEST_F(RunFigureTest, TheWordAtTheStartKeepsOffThePath) {
  Scenario scenario = some_fling();
  scenario.start = {900, 100};
  scenario.start_velocity = {0, 0};
  const std::string script = run_figure_script(scenario, dropped_rows(60), {});
  const double canvas = number_after(script, "svg size 960,");
  const double centre = 1 - (78 + (100 + 64 + 28.8) * 812 / (1920 + 57.6)) / canvas;
  EXPECT_GT(label_y(script, "start"), centre) << "the path leads down";
}

TEST_F(RunFigureTest, GrabsReleasesAndResizesHaveTheirTimes) {
  Scenario scenario = some_fling();
  scenario.events = {{std::int64_t{15}, Grab{}},
                     {std::int64_t{30}, Release{{100, 0}}},
                     {std::int64_t{45}, Resize{Size{1600, 1080}, std::nullopt}}};
  const std::string script = run_figure_script(scenario, dropped_rows(60), {});
  for (const std::string label : {"'grab 0.25 s'", "'release 0.5 s'", "'window 0.75 s'"})
    EXPECT_NE(script.find(label), std::string::npos) << label;
}

TEST_F(RunFigureTest, OneFastThrowLeavesTheRestItsColours) {
  Columns rows = dropped_rows(60);
  EXPECT_EQ(run_figure_script(some_fling(), rows, {}).find("set logscale cb"), std::string::npos);
  rows.vy_px_per_s[0] = 1e6;
  rows.vy_px_per_s[1] = 0.0;
  const std::string script = run_figure_script(some_fling(), rows, {});
  EXPECT_NE(script.find("set logscale cb\nset cbrange [100:1e+06]"), std::string::npos);
  EXPECT_NE(script.find("\n964 174 100\n"), std::string::npos) << "zero has no logarithm";
}

TEST_F(RunFigureTest, ContactsAtRestDoNotPileUp) {
  std::vector<Contact> contacts(20);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    contacts[i].wall = Wall::ground;
    contacts[i].x_px = 900 + static_cast<double>(i);
    contacts[i].y_px = 952;
  }
  const std::string script = run_figure_script(some_fling(), dropped_rows(60), contacts);
  EXPECT_EQ(lines_in_block(script, "ground_dots"), 1u);
  EXPECT_NE(script.find("'ground 20'"), std::string::npos);
}

// A backslash at its end would join the title's line with the next.
TEST_F(RunFigureTest, ATitleMayEndInABackslash) {
  SKIP_WITHOUT_GNUPLOT();
  draw_figure(path("a.svg"),
              figure_head({}, "back\\", "") + "set yrange [0:1]\nset xrange [0:1]\nplot NaN notitle\n");
  EXPECT_NE(read_text_file(path("a.svg")).find("<title>back\\</title>"), std::string::npos);
}

TEST_F(RunFigureTest, HasADarkModeThatTurnsPaperDarkAndInkLight) {
  SKIP_WITHOUT_GNUPLOT();
  draw_run_figure(path("a.svg"), some_fling(), colourful_rows(10), {});
  const std::string svg = read_text_file(path("a.svg"));
  EXPECT_NE(svg.find("@media (prefers-color-scheme: dark) { #gnuplot_canvas { filter: url(#dark) } }"),
            std::string::npos);
  EXPECT_NE(svg.find("<g id=\"gnuplot_canvas\">"), std::string::npos);
  std::istringstream matrix(svg.substr(svg.find("feColorMatrix values=\"") + 22));
  for (int channel = 0; channel < 3; ++channel) {
    double red = 0, green = 0, blue = 0, alpha = 0, offset = 0;
    matrix >> red >> green >> blue >> alpha >> offset;
    EXPECT_GT(offset, 0.9) << "black";
    EXPECT_NEAR(red + green + blue + offset, 0.07, 0.03) << "white";
  }
}

TEST_F(RunFigureTest, ALabelAmongDataHasAnEdgeOfPaper) {
  SKIP_WITHOUT_GNUPLOT();
  const Plot plot{.series = {{.x = {1.0, 2.0}, .y = {3.0, 4.0}}}, .texts = {{1.5, 3.5, "among data"}}};
  draw_figure(path("a.svg"), figure_script({.title = "Labels", .body = std::vector{plot}}));
  const std::string svg = read_text_file(path("a.svg"));
  const std::regex edge(R"(g\[(font-size="[0-9.]+")\] text \{ paint-order: stroke; stroke: #ffffff;)");
  std::smatch rule;
  ASSERT_TRUE(std::regex_search(svg, rule, edge));
  const std::size_t label = svg.find("<text>among data");
  ASSERT_NE(label, std::string::npos);
  const std::size_t group = svg.rfind("<g ", label);
  EXPECT_NE(svg.substr(group, label - group).find(rule[1]), std::string::npos);
  const std::size_t title = svg.find("<text>Labels");
  const std::size_t title_group = svg.rfind("<g ", title);
  EXPECT_EQ(svg.substr(title_group, title - title_group).find(rule[1]), std::string::npos);
}

TEST_F(RunFigureTest, TheLargestPictureKeepsItsBound) {
  SKIP_WITHOUT_GNUPLOT();
  Scenario scenario = some_fling();
  scenario.length = std::int64_t{1'000'000};
  for (std::int64_t i = 1; i < 100; ++i) {
    scenario.events.push_back({i, Resize{Size{static_cast<std::int32_t>(1920 - 9 * i), 1080}, std::nullopt}});
    scenario.events.push_back({i, Fling{{900, -100}}});
  }
  draw_run_figure(path("a.svg"), scenario, colourful_rows(1'000'001), contacts_at_each_wall(100'000));
  EXPECT_LT(std::filesystem::file_size(path("a.svg")), kSvgBytesMax);
}

TEST_F(RunFigureTest, DrawsRunsWithoutRowsAndWithOneRow) {
  SKIP_WITHOUT_GNUPLOT();
  draw_run_figure(path("none.svg"), some_fling(), Columns{}, {});
  draw_run_figure(path("one.svg"), some_fling(), colourful_rows(1), {});
  EXPECT_TRUE(is_well_formed(read_text_file(path("none.svg"))));
  EXPECT_TRUE(is_well_formed(read_text_file(path("one.svg"))));
}

TEST_F(RunFigureTest, TheSameRunGivesTheSameFile) {
  SKIP_WITHOUT_GNUPLOT();
  draw_run_figure(path("a.svg"), some_fling(), colourful_rows(600), {});
  draw_run_figure(path("b.svg"), some_fling(), colourful_rows(600), {});
  EXPECT_EQ(read_text_file(path("a.svg")), read_text_file(path("b.svg")));
}

TEST_F(RunFigureTest, ARefusedScriptQuotesGnuplotAndLeavesTheOldFile) {
  SKIP_WITHOUT_GNUPLOT();
  write_text_file(path("a.svg"), "old");
  try {
    draw_figure(path("a.svg"), "set terminal svg\nplot nonsense(\n");
    FAIL() << "no failure";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit_code(), ExitCode::program_fault);
    EXPECT_EQ(std::string(failure.what()).find(path("a.svg") + ": cannot be drawn: gnuplot says: "), 0u);
    EXPECT_NE(std::string(failure.what()).find("plot nonsense("), std::string::npos);
    EXPECT_EQ(std::string(failure.what()).find('\n'), std::string::npos);
  }
  EXPECT_EQ(read_text_file(path("a.svg")), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(RunFigureTest, AScriptThatDrawsNothingLeavesTheOldFile) {
  SKIP_WITHOUT_GNUPLOT();
  write_text_file(path("a.svg"), "old");
  EXPECT_THROW(draw_figure(path("a.svg"), "set terminal svg\n"), Failure);
  EXPECT_EQ(read_text_file(path("a.svg")), "old");
}

TEST_F(RunFigureTest, WithoutGnuplotTheMessageNamesTheRemedy) {
  write_text_file(path("a.svg"), "old");
  const char* const usual = std::getenv("PATH");
  const std::string usual_path = usual == nullptr ? "" : usual;
  setenv("PATH", path("nowhere").c_str(), 1);
  std::string sentence;
  ExitCode exit_code = ExitCode::agreed;
  try {
    draw_run_figure(path("a.svg"), some_fling(), colourful_rows(10), {});
  } catch (const Failure& failure) {
    sentence = failure.what();
    exit_code = failure.exit_code();
  }
  setenv("PATH", usual_path.c_str(), 1);
  EXPECT_EQ(exit_code, ExitCode::cannot_access);
  EXPECT_EQ(sentence, path("a.svg") +
                          ": cannot be drawn: gnuplot is not installed; `apt-get install gnuplot-nox`, or "
                          "tools/run does it");
  EXPECT_EQ(read_text_file(path("a.svg")), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(RunFigureTest, AMissingFolderIsReported) {
  try {
    draw_run_figure(path("no/such/a.svg"), some_fling(), colourful_rows(10), {});
    FAIL() << "no failure";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit_code(), ExitCode::cannot_access);
  }
}

}  // namespace
}  // namespace hyrax
