#include "tools/files/scenario_changes.h"

#include <gtest/gtest.h>

#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

// A throw of 300 frames at 60 Hz; `members` are added to it.
Scenario scenario_of(const std::string& start_x, const std::string& members = "") {
  return parse_scenario_file(
      R"({"format": "hyrax-scenario/1", "name": "throw", "window": {"width_px": 1920, "height_px": 1080},)"
      R"("sprite": {"width_px": 128, "height_px": 128}, "clock": {"rate_hz": 60}, "steps": 300,)"
      R"("start": {"x_px": )" +
          start_x + R"(, "y_px": 300, "vx_px_per_s": 900, "vy_px_per_s": 0})" + members + "}",
      "throw.json");
}

std::string events(const std::string& list) { return R"(, "events": [)" + list + "]"; }

constexpr char kFling[] = R"({"step": 10, "fling": {"vx_px_per_s": 1, "vy_px_per_s": 2}})";

TEST(ScenarioChanges, AreEmptyWhereBothPlayTheSame) {
  EXPECT_EQ(scenario_changes(scenario_of("400"), scenario_of("400.0")), "");
  EXPECT_EQ(scenario_changes(scenario_of("400"), scenario_of("400", R"(, "description": "another text")")),
            "");
}

TEST(ScenarioChanges, NameEachPointerWithBothValues) {
  const std::string two = std::string(kFling) + R"(, {"at_s": 0.5, "stop": {}})";
  const auto changes = [](const std::string& from, const std::string& to) {
    return scenario_changes(scenario_of("400", from), scenario_of("400.5", to));
  };
  const std::string x = "/start/x_px 400 -> 400.5";
  EXPECT_EQ(changes("", ""), x);
  EXPECT_EQ(changes("", R"(, "record": {"every": 2})"), x + R"(; /record none -> { "every": 2 })");
  EXPECT_EQ(changes(R"(, "record": {"every": 2})", ""), x + R"(; /record { "every": 2 } -> none)");
  EXPECT_EQ(changes(events(kFling), events(two)), x + R"(; /events/1 none -> { "at_s": 0.5, "stop": {} })");
  EXPECT_EQ(changes(events(two), events(kFling)), x + R"(; /events/1 { "at_s": 0.5, "stop": {} } -> none)");
}

TEST(ScenarioChanges, ListTheFirstOfMany) {
  Scenario to = scenario_of("1");
  to.start = {1.0, 2.0};
  to.start_velocity = {3.0, 4.0};
  const std::string four =
      "/start/x_px 400 -> 1; /start/y_px 300 -> 2; /start/vx_px_per_s 900 -> 3; /start/vy_px_per_s 0 -> 4";
  EXPECT_EQ(scenario_changes(scenario_of("400"), to), four);
  to.length = std::int64_t{200};
  EXPECT_EQ(scenario_changes(scenario_of("400"), to), four + "; and 1 more");
}

}  // namespace
}  // namespace hyrax
