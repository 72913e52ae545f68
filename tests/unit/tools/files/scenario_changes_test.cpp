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

TEST(ScenarioChanges, NameThePointerAndBothValues) {
  EXPECT_EQ(scenario_changes(scenario_of("400"), scenario_of("400.5")), "/start/x_px 400 -> 400.5");
}

TEST(ScenarioChanges, SayNoneForWhatIsNotThere) {
  const std::string text = scenario_changes(scenario_of("400"), scenario_of("400", events(kFling)));
  EXPECT_TRUE(text.starts_with("/events")) << text;
  EXPECT_NE(text.find("none -> "), text.npos) << text;
}

TEST(ScenarioChanges, ListTheFirstOfMany) {
  Scenario to = scenario_of("1");
  to.start = {1.0, 2.0};
  to.start_velocity = {3.0, 4.0};
  to.length = std::int64_t{200};
  to.window.width_px = 1000;
  const std::string text = scenario_changes(scenario_of("400"), to);
  EXPECT_TRUE(text.ends_with("; and 2 more")) << text;
}

}  // namespace
}  // namespace hyrax
