// The limits of every number that a sweep may vary are those of the scenario reader.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/scenario/numbers.h"
#include "tests/unit/tools/files/refusal.h"
#include "tools/files/json_pointer.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/sweep_reader.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

Json document() {
  return parse_json(read_text_file(HYRAX_SOURCE_DIR "/tests/unit/tools/files/all_numbers.json"), "test");
}

bool is_accepted(Json scenario, const std::string& pointer, const Json& value) {
  set_at(scenario, pointer, value);
  const std::string refused = refusal_of([&] { static_cast<void>(to_scenario(scenario, "test", "")); });
  return refused.find(pointer + ": ") == std::string::npos;
}

// Numbers that depend on others have no limit of their own that the reader alone decides.
void expect_same_limits(const Json& scenario, const std::string& pointer, bool has_upper_limit = true) {
  Scenario read = to_scenario(scenario, "test", "");
  const auto field = number_at(read, pointer);
  ASSERT_TRUE(field) << pointer;
  const bool is_whole = number_kind(pointer) != ScenarioNumberKind::real;
  const double below = is_whole ? field->low - 1.0 : std::nextafter(field->low, -1e300);
  const double above = is_whole ? field->high + 1.0 : std::nextafter(field->high, 1e300);
  EXPECT_FALSE(field->allows(below));
  EXPECT_FALSE(is_accepted(scenario, pointer, below)) << pointer;
  EXPECT_TRUE(is_accepted(scenario, pointer, field->low)) << pointer;
  if (!has_upper_limit) return;
  EXPECT_FALSE(field->allows(above));
  EXPECT_TRUE(is_accepted(scenario, pointer, field->high)) << pointer;
  EXPECT_FALSE(is_accepted(scenario, pointer, above)) << pointer;
}

TEST(SweepLimits, OfSizesPositionsAndSpeedsAreTheReaders) {
  for (const char* const pointer :
       {"/window/width_px", "/window/height_px", "/sprite/width_px", "/sprite/height_px", "/start/x_px",
        "/start/y_px", "/start/vx_px_per_s", "/start/vy_px_per_s", "/events/0/fling/vx_px_per_s",
        "/events/0/fling/vy_px_per_s", "/events/1/place/x_px", "/events/1/place/y_px",
        "/events/4/release/vx_px_per_s", "/events/4/release/vy_px_per_s", "/events/5/resize/window/width_px",
        "/events/5/resize/sprite/height_px", "/clock/jitter/fraction", "/parameters/GRAVITY"})
    expect_same_limits(document(), pointer);
  expect_same_limits(document(), "/record/every", false);  // The reader lowers a larger one.
}

TEST(SweepLimits, OfClocksAreTheReaders) {
  Json fixed = document();
  set_at(fixed, "/events", Json::Array{});
  expect_same_limits(fixed, "/clock/rate_hz");
  expect_same_limits(fixed, "/steps");
  set_at(fixed, "/clock/jitter",
         Json::Object{{"kind", "normal"}, {"sigma_s", 0.1}, {"seed", std::uint64_t{1}}});
  expect_same_limits(fixed, "/clock/jitter/sigma_s");
  set_at(fixed, "/clock/jitter",
         Json::Object{{"kind", "missed_frames"}, {"probability", 0.1}, {"seed", std::uint64_t{1}}});
  expect_same_limits(fixed, "/clock/jitter/probability");
  expect_same_limits(fixed, "/clock/jitter/seed", false);
  set_at(fixed, "/clock", Json::Object{{"dt_s", 0.5}});
  expect_same_limits(fixed, "/clock/dt_s");
  set_at(fixed, "/clock", Json::Object{{"dt_s", Json::Array{0.5, 0.25}}});
  set_at(fixed, "/steps", 2);
  expect_same_limits(fixed, "/clock/dt_s/1");
  expect_same_limits(fixed, "/steps");  // The array's length, and nothing else.
}

std::string sweep_text(std::int64_t members, const std::string& x_px) {
  return R"({"format": "hyrax-sweep/1", "members": )" + std::to_string(members) +
         R"(, "seed": 1, "vary": {"/start/x_px": )" + x_px + R"(}, "base": {"format": "hyrax-scenario/1",
    "window": {"width_px": 8, "height_px": 6}, "sprite": {"width_px": 6, "height_px": 3},
    "start": {"x_px": 1, "y_px": 2}, "clock": {"rate_hz": 60}, "steps": 1}})";
}

TEST(SweepNames, AreCutToWhatAScenarioMayHave) {
  const std::string stem(70, 'a'), text = sweep_text(1'000'000, R"({"uniform": [0, 1]})");
  const SweepFile file = parse_sweep(text, "folder/" + stem + ".json");
  EXPECT_EQ(member_scenario(file.sweep, 7).name, std::string(64 - 9, 'a') + "-member-7");
  EXPECT_EQ(member_scenario(file.sweep, 999'999).name, std::string(64 - 14, 'a') + "-member-999999");
  EXPECT_EQ(member_scenario(parse_sweep(text, "Two{B.json").sweep, 7).name, "-wo---member-7");
}

// Its last member alone is beyond the limit of a position.
std::string refusal_of_grid(std::int64_t members) {
  const std::string grid = R"({"grid": [0, 1000000100000, )" + std::to_string(members) + "]}";
  return refusal_of([&] { static_cast<void>(parse_sweep(sweep_text(members, grid), "far.json")); });
}

TEST(SweepLimits, AMemberBeyondThemIsNamedUpToTheMillionth) {
  EXPECT_EQ(refusal_of_grid(2),
            "far.json: member 1: /start/x_px: must be -1e+12 .. 1e+12 (found 1000000100000)");
  EXPECT_EQ(refusal_of_grid(1'000'000),
            "far.json: member 999999: /start/x_px: must be -1e+12 .. 1e+12 (found 1000000100000)");
  EXPECT_EQ(refusal_of_grid(1'000'001),
            "far.json: /vary/~1start~1x_px: /start/x_px: must be -1e+12 .. 1e+12 (found 1000000100000)");
}

TEST(SweepLimits, AreOfEveryNumberOfAScenario) {
  Scenario scenario = to_scenario(document(), "test", "");
  for (const char* const pointer : {"/events/0/step", "/events/1/at_s", "/events/2/hitch/dt_s", "/steps"})
    EXPECT_TRUE(number_at(scenario, pointer) && number_at(scenario, pointer)->is_timing) << pointer;
  for (const char* const pointer :
       {"", "/", "/name", "/start", "/start/x_px/0", "/clock/dt_s", "/clock/jitter/kind",
        "/clock/jitter/sigma_s", "/events", "/events/6/step", "/events/-/step", "/events/0x/step",
        "/events/3/grab", "/events/0/place/x_px", "/duration_s", "/expect/final_x_px/0",
        "/events/5/resize/window", "start/x_px"})
    EXPECT_FALSE(number_at(scenario, pointer)) << pointer;
}

}  // namespace
}  // namespace hyrax
