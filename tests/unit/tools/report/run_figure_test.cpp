
#include <array>
#include <cmath>
#include <limits>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/tools/report/picture_faults.h"
#include "tools/report/look.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

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

// What the picture shows where there is room for it.
std::string wide(const std::string& svg) { return svg.substr(0, svg.find("<svg class=\"narrow\"")); }

bool has_text(const std::string& svg, const std::string& text) {
  return wide(svg).find(">" + text + "</text>") != std::string::npos;
}

// The part of the picture with this name.
std::string part_of(const std::string& svg, const std::string& name) {
  const std::string begin = "\"><title>" + name + "</title>";
  const std::size_t at = wide(svg).find(begin);
  return at == std::string::npos ? "" : svg.substr(at, svg.find("</g>", at) - at);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

SvgBox window_of(const std::string& svg) { return rectangle_of(part_of(svg, "window"), "[^\"]*"); }

// The points of the path where it was flown, or with some dashes.
std::vector<SvgPoint> path_points(const std::string& svg, const std::string& dashes = "") {
  const std::string part = part_of(svg, "path of the centre");
  const std::regex line("<path d=\"M([^\"]*)\" fill=\"none\" stroke=\"[^\"]*\" stroke-width=\"[^\"]*\"" +
                        (dashes.empty() ? "" : " stroke-dasharray=\"" + dashes + "\"") + " ?/>");
  const std::regex point("([-0-9.]+),([-0-9.]+)");
  std::vector<SvgPoint> points;
  for (std::sregex_iterator found(part.begin(), part.end(), line), end; found != end; ++found) {
    const std::string places = (*found)[1];
    for (std::sregex_iterator at(places.begin(), places.end(), point); at != end; ++at)
      points.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
  }
  return points;
}

Columns dropped_rows(std::int64_t count) {
  Columns rows;
  for (std::int64_t i = 0; i < count; ++i)
    rows.append(
        {i, static_cast<double>(i) / 60, 1.0 / 60, 900, 100.0 + 10.0 * static_cast<double>(i), 0, 600, 0});
  return rows;
}

TEST(RunSvg, DrawsTheWindowToScale) {
  const SvgBox window = window_of(run_svg(some_fling(), colourful_rows(100), {}));
  EXPECT_NEAR(window.width() / window.height(), 1920.0 / 1080.0, 1e-3);
  EXPECT_GT(window.width(), 700.0);
}

TEST(RunSvg, TheBarOfSpeedsHasTheSlowOnesBelow) {
  const std::string svg = run_svg(some_fling(), colourful_rows(100), {});
  const auto top_of = [&svg](double part) { return rectangle_of(svg, speed_colour(part)).top; };
  EXPECT_GT(top_of(0.0), top_of(1.0) + 100.0);
}

TEST(RunSvg, DrawsThePathOfTheCentre) {
  Columns rows;
  rows.append({0, 0.0, 0.0, 100, 200, 600, 0, 0});
  rows.append({1, 1.0 / 60, 1.0 / 60, 110, 200, 600, 0, 0});
  const std::string svg = run_svg(some_fling(), rows, {});
  const std::vector<SvgPoint> points = path_points(svg);
  const SvgBox window = window_of(svg);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR((points[0].x - window.left) / window.width(), 164.0 / 1920.0, 1e-3);
  EXPECT_NEAR((points[0].y - window.top) / window.height(), 264.0 / 1080.0, 1e-3);
  EXPECT_NEAR((points[1].x - points[0].x) / window.width(), 10.0 / 1920.0, 1e-4);
}

TEST(RunSvg, AJumpIsNotDrawnAsFlight) {
  Columns rows;
  rows.append({0, 0.0, 0.0, 100, 200, 600, 0, 0});
  rows.append({1, 1.0 / 60, 1.0 / 60, 1100, 200, 600, 0, 0});
  const std::string svg = run_svg(some_fling(), rows, {});
  EXPECT_EQ(path_points(svg, dashes_of(Dash::short_dashes)).size(), 2u);
  EXPECT_TRUE(path_points(svg).empty());
  EXPECT_NE(part_of(svg, "not flown").find(dashes_of(Dash::short_dashes)), std::string::npos)
      << "in the legend";
}

TEST(RunSvg, TheWayBetweenRowsFarApartIsNotMadeUp) {
  Columns rows;
  rows.append({0, 0.0, 0.0, 100, 200, 600, 0, 0});
  rows.append({100, 100.0 / 60, 1.0 / 60, 1100, 200, 600, 0, 0});
  const std::string svg = run_svg(some_fling(), rows, {});
  EXPECT_EQ(path_points(svg, dashes_of(Dash::dots)).size(), 2u);
  EXPECT_NE(part_of(svg, "not recorded").find(dashes_of(Dash::dots)), std::string::npos) << "in the legend";
  EXPECT_TRUE(has_text(svg, "the first 100 of 600 steps"));
}

TEST(RunSvg, TheLegendCountsContactsThatAreNotDrawn) {
  const std::string svg =
      run_svg(some_fling(), colourful_rows(10), contacts_at_each_wall(4), WallCounts{5, 6, 7, 1'234'567});
  for (const std::string label : {"contacts: left 5", "right 6", "top 7", "ground 1,234,567"})
    EXPECT_TRUE(has_text(svg, label)) << label;
}

TEST(RunSvg, CountsAndSpeedsAreWrittenForPeople) {
  Columns rows = dropped_rows(2);
  const auto subtitle_says = [&rows](const Clock& clock, const std::string& text) {
    Scenario scenario = some_fling();
    scenario.clock = clock;
    EXPECT_TRUE(has_text(run_svg(scenario, rows, {}),
                         "1 step · 0.0166667 s · " + text + " · window 1920 × 1080 px · sprite 128 × 128 px"))
        << text;
  };
  const Jitter jitter{Jitter::Kind::uniform, 0.1, 1};
  subtitle_says({FixedRate{60}, {}}, "60 Hz");
  subtitle_says({FixedRate{59.94}, jitter}, "59.94 Hz with jitter");
  subtitle_says({FixedStep{0.02}, {}}, "dt 0.02 s");
  subtitle_says({RecordedSteps{{1.0 / 60.0}}, {}}, "recorded frames");
  Scenario fast = some_fling();
  fast.start_velocity = {11'400, 0};
  rows.vx_px_per_s[0] = 11'400;
  EXPECT_TRUE(has_text(run_svg(fast, rows, {}), "11,400 px/s"));
  EXPECT_TRUE(has_text(run_svg(fast, rows, {}), "speed, px/s"));
}

TEST(RunSvg, ARunThatBecomesNonFiniteSaysSoAndMarksThePlace) {
  Columns rows = colourful_rows(100);
  const auto has_mark = [&] {
    const std::string svg = run_svg(some_fling(), rows, {});
    const bool has_note = has_text(svg, "vx is NaN from step 100 of 600 (1.67 s)");
    const bool has_cross =
        part_of(svg, "path of the centre").find(colour_of(Tone::vermilion)) != std::string::npos;
    EXPECT_EQ(has_note, has_cross);
    EXPECT_EQ(has_cross, has_text(svg, "not finite"));
    return has_cross;
  };
  EXPECT_FALSE(has_mark());
  rows.append({100, 100.0 / 60, 1.0 / 60, std::nan(""), 500.0, std::nan(""), 0.0, 0});
  EXPECT_TRUE(has_mark());
}

TEST(RunSvg, LeavesOutRowsThatAreNotFinite) {
  Columns rows = colourful_rows(100);
  rows.x_px[50] = std::numeric_limits<double>::quiet_NaN();
  rows.vy_px_per_s[51] = std::numeric_limits<double>::infinity();
  const std::string path = part_of(run_svg(some_fling(), rows, {}), "path of the centre");
  EXPECT_EQ(path.find("inf"), std::string::npos);
  EXPECT_EQ(path.find("nan"), std::string::npos);
}

TEST(RunSvg, APathAndAPictureHaveABound) {
  constexpr std::size_t kSvgBytesMax = 400'000;
  Scenario scenario = some_fling();
  scenario.length = std::int64_t{1'000'000};
  for (std::int64_t i = 1; i < 100; ++i) {
    scenario.events.push_back({i, Resize{Size{static_cast<std::int32_t>(1920 - 9 * i), 1080}, std::nullopt}});
    scenario.events.push_back({i, Fling{{900, -100}}});
  }
  const std::string svg = run_svg(scenario, colourful_rows(1'000'001), contacts_at_each_wall(100'000));
  EXPECT_LE(path_points(svg).size(), 2 * kPathPointsMax);
  EXPECT_NE(svg.find(">path drawn up to "), std::string::npos) << "and says what is missing";
  EXPECT_LT(svg.size(), kSvgBytesMax);
}

TEST(RunSvg, AStartFarOutsideLeavesTheWindowLargeAndIsNoted) {
  Scenario scenario = some_fling();
  scenario.start = {-1'000'000, 1'000'000};
  Columns rows;
  rows.append({0, 0.0, 0.0, -1'000'000, 1'000'000, 0, 0, 0});
  rows.append({1, 1.0 / 60, 1.0 / 60, 0, 952, 0, 0, 9});
  scenario.length = std::int64_t{1};
  const std::string svg = run_svg(scenario, rows, {});
  EXPECT_GT(window_of(svg).width(), 700.0);
  EXPECT_TRUE(has_text(svg, "starts far outside, at x -1,000,000, y 1,000,000 px"));
}

TEST(RunSvg, HasNamesForPeopleAndEndsItsParts) {
  Scenario scenario = some_fling();
  scenario.name = "it's <b> & \"q\" {x}_y^z \\n $(ls)\n`ls`";
  const std::string svg = run_svg(scenario, colourful_rows(600), contacts_at_each_wall(9));
  EXPECT_EQ(count_of(svg, "<g"), count_of(svg, "</g>"));
  EXPECT_NE(svg.find("<title>it's &lt;b> &amp; &quot;q&quot; {x}_y^z \\n $(ls) `ls`</title>"),
            std::string::npos);
  for (const std::string name : {"window", "path of the centre", "sprite at contacts", "contact: ground"})
    EXPECT_FALSE(part_of(svg, name).empty()) << name;
  for (const std::int64_t count : {0, 1}) {
    const std::string few = run_svg(some_fling(), colourful_rows(count), {});
    EXPECT_EQ(count_of(few, "<g"), count_of(few, "</g>")) << count;
  }
}

TEST(RunSvg, TheWordAtTheStartKeepsOffThePath) {
  Scenario scenario = some_fling();
  scenario.start = {900, 100};
  scenario.start_velocity = {0, 0};
  const std::string svg = run_svg(scenario, dropped_rows(60), {});
  EXPECT_LT(place_of(svg, "start").y, path_points(svg).front().y) << "the path leads down";
}

TEST(RunSvg, EveryKindOfInputHasItsTime) {
  Scenario scenario = some_fling();
  scenario.events = {{std::int64_t{6}, Hitch{0.5}},
                     {std::int64_t{12}, Stop{}},
                     {std::int64_t{15}, Grab{}},
                     {std::int64_t{18}, Place{{300, 300}}},
                     {std::int64_t{30}, Release{{100, 0}}},
                     {std::int64_t{36}, Fling{{100, 0}}},
                     {std::int64_t{45}, Resize{Size{1600, 1080}, std::nullopt}}};
  const std::string svg = run_svg(scenario, dropped_rows(60), {});
  for (const std::string label : {"hitch 0.1 s", "stop 0.2 s", "grab 0.25 s", "place 0.3 s", "release 0.5 s",
                                  "fling 0.6 s", "window 0.75 s"})
    EXPECT_TRUE(has_text(svg, label)) << label;
  for (const char* const name : {"window", "resized window"})
    EXPECT_NE(part_of(svg, name).find(dashes_of(Dash::long_dashes)), std::string::npos) << name;
  EXPECT_NE(dashes_of(Dash::long_dashes), dashes_of(Dash::short_dashes)) << "of what is not flown";
}

TEST(RunSvg, OneFastThrowLeavesTheRestItsColours) {
  Columns rows = dropped_rows(60);
  EXPECT_FALSE(has_text(run_svg(some_fling(), rows, {}), "10⁵"));
  rows.vy_px_per_s[0] = 1e6;
  rows.vy_px_per_s[1] = 0.0;
  const std::string svg = run_svg(some_fling(), rows, {});
  for (const std::string tick : {"100", "1,000", "10,000", "10⁵"}) EXPECT_TRUE(has_text(svg, tick)) << tick;
}

TEST(RunSvg, ThePathHasTheColourOfItsSpeedInTheBar) {
  for (const double fastest : {4e4, 1e5}) {  // An even scale, and a logarithmic one.
    Columns rows = dropped_rows(60);
    std::fill(rows.vy_px_per_s.begin(), rows.vy_px_per_s.begin() + 12, 200.0);
    std::fill(rows.vy_px_per_s.begin() + 12, rows.vy_px_per_s.end(), 1e4);
    rows.vy_px_per_s[0] = fastest;
    const std::string svg = run_svg(some_fling(), rows, {}), path = part_of(svg, "path of the centre");
    const std::string colour = path.substr(path.rfind("stroke=\"#") + 8, 7);
    const SvgBox box = rectangle_of(svg, colour);
    EXPECT_NEAR(place_of(svg, "10,000").y, box.centre().y, 1.5 * box.height()) << fastest;
  }
}

TEST(RunSvg, ContactsAtRestDoNotPileUp) {
  std::vector<Contact> contacts(20);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    contacts[i].wall = Wall::ground;
    contacts[i].x_px = 900 + static_cast<double>(i);
    contacts[i].y_px = 952;
  }
  const std::string svg = run_svg(some_fling(), dropped_rows(60), contacts);
  EXPECT_EQ(count_of(wide(svg), "r=\"2.8\" fill=\"" + colour_of(Tone::orange)), 2u)
      << "in the picture and in the legend";
  EXPECT_TRUE(has_text(svg, "contacts: ground 20"));
}

TEST(RunSvg, ACornerShowsBothItsDots) {
  std::vector<Contact> contacts(2);
  for (Contact& contact : contacts) contact.x_px = 1792, contact.y_px = 952, contact.step = 3;
  contacts[0].wall = Wall::right;
  contacts[1].wall = Wall::ground;
  const std::string svg = run_svg(some_fling(), dropped_rows(60), contacts);
  std::vector<std::string> places;
  for (const std::string wall : {"right", "ground"}) {
    const std::string part = part_of(svg, "contact: " + wall);
    places.push_back(part.substr(part.find("<circle cx"), 30));
  }
  EXPECT_NE(places[0], places[1]);
}

// Of the arrow's head and shaft no part is outside the window.
TEST(RunSvg, TheArrowOfTheThrowIsShortAndInsideTheWindow) {
  const std::string svg = run_svg(some_fling(), colourful_rows(100), {});
  std::smatch shaft;
  const std::string text = wide(svg);
  ASSERT_TRUE(std::regex_search(
      text, shaft,
      std::regex("<path d=\"M([-0-9.]+),([-0-9.]+) ([-0-9.]+),([-0-9.]+)\" fill=\"none\" stroke=\"" +
                 colour_of(Tone::ink) + "\" stroke-width=\"2\"")));
  const SvgBox window = window_of(svg);
  for (const std::size_t end : {1u, 3u}) {
    EXPECT_GE(std::stod(shaft[end]), window.left);
    EXPECT_LE(std::stod(shaft[end]), window.right);
    EXPECT_GE(std::stod(shaft[end + 1]), window.top);
    EXPECT_LE(std::stod(shaft[end + 1]), window.bottom);
  }
  EXPECT_LT(std::hypot(std::stod(shaft[3]) - std::stod(shaft[1]), std::stod(shaft[4]) - std::stod(shaft[2])),
            50.0);
}

// Windows much longer than wide, and larger and smaller than any picture: every tick within the window, every
// text whole and readable.
TEST(RunSvg, OddWindowsHaveNoTickOutsideAndNoTextThatOverlaps) {
  for (const Size& size : {Size{200, 4000}, Size{8000, 200}, Size{1920, 1080}, Size{40, 40}}) {
    SCOPED_TRACE(testing::Message() << size.width_px << " x " << size.height_px);
    Scenario scenario = some_fling();
    scenario.window = size;
    scenario.sprite = {32, 32};
    Columns rows;
    for (std::int64_t i = 0; i < 60; ++i)
      rows.append({i, static_cast<double>(i) / 60, 1.0 / 60,
                   std::min(8.0 * size.width_px / 1000.0 * static_cast<double>(i), size.width_px - 32.0),
                   std::min(8.0 * size.height_px / 1000.0 * static_cast<double>(i), size.height_px - 32.0),
                   600, 600, 0});
    const std::string svg = run_svg(scenario, rows, {});
    EXPECT_EQ(picture_faults(svg), std::vector<std::string>{});
    const std::string text = wide(svg);
    const std::regex tick("<path d=\"M([-0-9.]+),([-0-9.]+) ([-0-9.]+),([-0-9.]+)\" fill=\"none\" stroke=\"" +
                          colour_of(Tone::faint) + "\" stroke-width=\"1\"/>");
    const SvgBox window = window_of(svg);
    std::size_t ticks = 0;
    for (std::sregex_iterator found(text.begin(), text.end(), tick), end; found != end; ++found, ++ticks) {
      const double x = std::stod((*found)[1]), y = std::stod((*found)[2]);
      if (x == std::stod((*found)[3]))
        EXPECT_TRUE(x >= window.left - 0.1 && x <= window.right + 0.1) << x;
      else
        EXPECT_TRUE(y >= window.top - 0.1 && y <= window.bottom + 0.1) << y;
    }
    EXPECT_GE(ticks, 4u);
  }
}

}  // namespace
}  // namespace hyrax
