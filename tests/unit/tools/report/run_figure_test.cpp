
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

Columns dropped_rows(std::int64_t count) {
  Columns rows;
  for (std::int64_t i = 0; i < count; ++i)
    rows.append(
        {i, static_cast<double>(i) / 60, 1.0 / 60, 900, 100.0 + 10.0 * static_cast<double>(i), 0, 600, 0});
  return rows;
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
}

TEST(RunSvg, TheLegendSaysHowManyFramesABeadIsForAndWhatIsNotRecorded) {
  for (const auto& [dt_s, label] : {std::pair(0.1, "every frame"),
                                    {0.05, "every 2 frames"},
                                    {1.0 / 60, "every 6 frames"},
                                    {0.0016, ""}}) {
    Columns rows;
    for (std::int64_t i = 0; i < 50; ++i) {
      const double t_s = dt_s * static_cast<double>(i);
      rows.append({i, t_s, dt_s, 900, 100 + 600 * t_s, 0, 600, 0});
    }
    const std::string svg = run_svg(some_fling(), rows, {});
    EXPECT_EQ(svg.find(">every ") != std::string::npos, label[0] != '\0') << dt_s;
    EXPECT_TRUE(label[0] == '\0' || has_text(svg, label)) << label;
  }
  for (const auto& [x_px, is_far] : {std::pair(120.0, false), {300.0, true}}) {
    Columns rows;
    rows.append({0, 0.0, 0.0, 100, 100, 600, 0, 0});
    rows.append({2, 2.0 / 60, 1.0 / 60, x_px, 100, 600, 0, 0});
    Scenario scenario = some_fling();
    scenario.events = {{std::int64_t{1}, Fling{{5.0, 6.0}}}, {std::int64_t{2}, Stop{}}};
    const std::string svg = run_svg(scenario, rows, {});
    EXPECT_EQ(has_text(svg, "not recorded"), is_far) << x_px;
    EXPECT_TRUE(has_text(svg, "stop 0.0333 s"));
    EXPECT_EQ(svg.find(">fling "), std::string::npos) << "of a row that is not recorded";
  }
}

TEST(RunSvg, ARunThatBecomesNonFiniteSaysSoMarksThePlaceAndLeavesOutTheseRows) {
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
  rows.x_px[50] = std::numeric_limits<double>::quiet_NaN();
  rows.vy_px_per_s[51] = std::numeric_limits<double>::infinity();
  const std::string path = part_of(run_svg(some_fling(), rows, {}), "path of the centre");
  EXPECT_EQ(path.find("inf"), std::string::npos);
  EXPECT_EQ(path.find("nan"), std::string::npos);
}

TEST(RunSvg, APathAndAPictureHaveABound) {
  constexpr std::size_t kSvgBytesMax = 400'000;
  Scenario scenario = some_fling();
  scenario.length = std::int64_t{100'000};
  for (std::int64_t i = 1; i < 100; ++i) {
    scenario.events.push_back({i, Resize{Size{static_cast<std::int32_t>(1920 - 9 * i), 1080}, std::nullopt}});
    scenario.events.push_back({i, Fling{{900, -100}}});
  }
  const Columns rows = colourful_rows(100'001);
  const std::string svg = run_svg(scenario, rows, contacts_at_each_wall(1'000));
  std::size_t points = 0;
  for (const Stroke& stroke : make_run_scene(scenario, rows, {}, 640.0).path.strokes)
    points += stroke.points.size();
  EXPECT_LE(points, 2 * kPathPointsMax);
  EXPECT_NE(svg.find(">path drawn up to "), std::string::npos) << "and says what is missing";
  EXPECT_LT(svg.size(), kSvgBytesMax);
}

TEST(RunSvg, NotesWhatItDoesNotShow) {
  Scenario scenario = some_fling();
  scenario.length = std::int64_t{1};
  const auto says = [&scenario](const Position& from, const Position& to, const std::string& note) {
    Columns rows;
    rows.append({0, 0.0, 0.0, from.x_px, from.y_px, 0, 0, 0});
    rows.append({1, 1.0 / 60, 1.0 / 60, to.x_px, to.y_px, 0, 0, 9});
    const std::string svg = run_svg(scenario, rows, {});
    EXPECT_GT(window_of(svg).width(), 700.0);
    EXPECT_TRUE(has_text(svg, note)) << note;
  };
  says({-1'000'000, 1'000'000}, {0, 952}, "starts far outside, at x -1,000,000, y 1,000,000 px");
  scenario.window = {4000, 200};  // No part of it is visited.
  says({-1'000'000, 1'000'000}, {-1'000'000, 1'000'000},
       "starts far outside, at x -1,000,000, y 1,000,000 px");
  scenario.window = {1920, 1080};
  says({0, 952}, {30'000, 0.5}, "ends far outside, at x 30,000, y 0.5 px");
  scenario.length = std::int64_t{600};
  says({0, 952}, {0, 952}, "the first 1 of 600 steps");
  says({0, 952}, {0, 952}, "start, end");
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
