// Pictures of runs: what they show as data, the texts and the path.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <string>

#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/report/picture_faults.h"
#include "tools/report/look.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

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
  for (std::int64_t i = 0; i < count; ++i)
    contacts.push_back({.step = i + 1,
                        .last_step = i + 1,
                        .wall = kWalls[static_cast<std::size_t>(i) % 4],
                        .x_px = static_cast<double>(i * 59 % 1792),
                        .y_px = static_cast<double>(i * 31 % 952)});
  return contacts;
}

// What the picture shows where there is room for it.
std::string wide(const std::string& svg) { return svg.substr(0, svg.find("<svg class=\"narrow\"")); }

// The part of the picture with this name.
std::string part_of(const std::string& svg, const std::string& name) {
  const std::string begin = "\"><title>" + name + "</title>";
  const std::size_t at = wide(svg).find(begin);
  return at == std::string::npos ? "" : svg.substr(at, svg.find("</g>", at) - at);
}

Columns dropped_rows(std::int64_t count, double dt_s = 1.0 / 60) {
  Columns rows;
  for (std::int64_t i = 0; i < count; ++i) {
    const double t_s = dt_s * static_cast<double>(i);
    rows.append({i, t_s, dt_s, 900, 100.0 + 600.0 * t_s, 0, 600, 0});
  }
  return rows;
}

Columns two_rows(const Position& from, const Position& to, std::int64_t last_step = 1) {
  Columns rows;
  rows.append({0, 0.0, 0.0, from.x_px, from.y_px, 600, 0, 0});
  rows.append({last_step, static_cast<double>(last_step) / 60, 1.0 / 60, to.x_px, to.y_px, 600, 0, 9});
  return rows;
}

// All texts of a picture, and whether its path has a cross.
std::string shown(const std::string& what, const std::string& svg) {
  const std::string path = part_of(svg, "path of the centre");
  for (const char* const number : {"inf", "nan"}) EXPECT_EQ(path.find(number), std::string::npos) << what;
  std::string text = what;
  if (path.find(colour_of(Tone::vermilion)) != path.npos) text += ", a cross";
  for (const ShownText& each : texts_in(wide(svg))) text += " | " + each.text;
  return text + "\n";
}

TEST(RunSvg, HasTheTextsApproved) {
  const Scenario fling = fling_at(60.0, 600);
  std::string text =
      shown("contacts that are not drawn",
            run_svg(fling, colourful_rows(10), contacts_at_each_wall(4), WallCounts{5, 6, 7, 1'234'567}));

  const Jitter jitter{Jitter::Kind::uniform, 0.1, 1};
  for (const Clock& clock : {Clock{FixedRate{60}, {}},
                             {FixedRate{59.94}, jitter},
                             {FixedStep{0.02}, {}},
                             {RecordedSteps{{1.0 / 60.0}}, {}}}) {
    Scenario scenario = fling;
    scenario.clock = clock;
    text += shown("a clock", run_svg(scenario, dropped_rows(2), {}));
  }
  Columns fast = dropped_rows(2);
  fast.vx_px_per_s[0] = 11'400;
  text += shown("fast", run_svg(fling, fast, {}));

  for (const double dt_s : {0.1, 0.05, 1.0 / 60, 0.0016})
    text +=
        shown("beads of frames of " + six_digits(dt_s) + " s", run_svg(fling, dropped_rows(50, dt_s), {}));
  Scenario flung = fling;
  flung.events = {{std::int64_t{1}, Fling{{5.0, 6.0}}}, {std::int64_t{2}, Stop{}}};
  for (const double x_px : {120.0, 300.0})
    text += shown("a row between is not recorded", run_svg(flung, two_rows({100, 100}, {x_px, 100}, 2), {}));

  Columns rows = colourful_rows(100);
  text += shown("finite", run_svg(fling, rows, {}));
  rows.append({100, 100.0 / 60, 1.0 / 60, std::nan(""), 500.0, std::nan(""), 0.0, 0});
  text += shown("not finite", run_svg(fling, rows, {}));
  rows.x_px[50] = std::numeric_limits<double>::quiet_NaN();
  rows.vy_px_per_s[51] = std::numeric_limits<double>::infinity();
  text += shown("not finite earlier", run_svg(fling, rows, {}));

  const Position far{-1'000'000, 1'000'000}, corner{0, 952};
  for (const auto& [what, from, to, window, steps] :
       std::initializer_list<std::tuple<const char*, Position, Position, Size, std::int64_t>>{
           {"starts far outside", far, corner, {1920, 1080}, 1},
           {"no part of the window is visited", far, far, {4000, 200}, 1},
           {"ends far outside", corner, {30'000, 0.5}, {1920, 1080}, 1},
           {"the first step of many", corner, corner, {1920, 1080}, 600}}) {
    Scenario scenario = fling;
    scenario.window = window;
    scenario.length = steps;
    const std::string svg = run_svg(scenario, two_rows(from, to), {}), place = part_of(svg, "window");
    text += shown(what, svg) + place.substr(place.find("<rect"));
  }

  // Two bounces at one place, then it rests: each bounce has a dot, a resting contact has none.
  Columns settled = dropped_rows(60);
  for (std::size_t row = 20; row < settled.size(); ++row) settled.y_px[row] = 952;
  std::vector<Contact> contacts;
  for (const std::int64_t step : {10, 15, 20, 22, 59})
    contacts.push_back({.step = step, .wall = Wall::ground, .x_px = 900, .y_px = 952});
  const std::string piled = run_svg(fling, settled, contacts);
  text += shown("a resting contact", piled);
  const std::regex ground("Z\" fill=\"" + colour_of(Tone::orange) + "\">");
  const std::string seen = wide(piled);
  EXPECT_EQ(std::distance(std::sregex_iterator(seen.begin(), seen.end(), ground), {}), 4)
      << "in the picture, with the one in the last row, and in the legend";
  expect_approved("tests/unit/tools/report/run_texts.txt", text);
}

TEST(RunSvg, APathAndAPictureHaveABound) {
  constexpr std::size_t kSvgBytesMax = 400'000;
  Scenario scenario = fling_at(60.0, 600);
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

}  // namespace
}  // namespace hyrax
