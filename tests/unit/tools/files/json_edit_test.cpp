// Values in a JSON text are set, and nothing else changes; what two scenarios differ in.
#include <gtest/gtest.h>

#include "tools/files/json_edit.h"
#include "tools/files/scenario_changes.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

constexpr char kHash[] = "0123456789abcdef0123456789abcdef";
constexpr char kOldHash[] = "ffffffffffffffffffffffffffffffff";

constexpr char kBegin[] =
    R"({"format": "hyrax-scenario/1", "name": "x", "description": "\"{ \\\u00e9 state_hash",
 "window": {"width_px": 10, "height_px": 10}, "sprite" :{"width_px":1,"height_px":1},
	"start": { "x_px": 1e0, "y_px": 2.50 }, "clock": { "dt_s": [0.1, 0.2] })";

std::string scenario_with(const std::string& end) { return kBegin + end; }

// The text is a valid scenario before and after, and then has the hash.
void expect_text(const std::string& before, const std::string& after) {
  static_cast<void>(parse_scenario(before, "before"));
  const std::string found =
      with_elements(before, {"expect", "state_hash"}, {std::string("\"") + kHash + '"'});
  EXPECT_EQ(found, after);
  EXPECT_EQ(parse_scenario(found, "after").expect->state_hash, kHash);
}

TEST(JsonEdit, ReplacesTheHashAndFindsItByItsKeyHoweverItIsWritten) {
  const auto text = [](const std::string& hash) {
    return scenario_with(",\n  \"expect\" :\r\n{ \"contacts\": {\"top\": [0, 1] },\"state_hash\":\t\"" +
                         hash + "\" , \"finite\": true} } \n\n");
  };
  const auto escaped = [](const std::string& hash) {
    return scenario_with(R"(, "\u0065xpect": {"state\u005fhash": ")" + hash + "\"}}");
  };
  expect_text(text(kOldHash), text(kHash));
  expect_text(text(kHash), text(kHash));
  expect_text(escaped(kOldHash), escaped(kHash));
}

TEST(JsonEdit, SetsTheElementsOfAnArray) {
  EXPECT_EQ(with_elements("{\"a\" : {\"b\":[ 1,\n 2e0 ] }}", {"a", "b"}, {"3", "4.5"}),
            "{\"a\" : {\"b\":[ 3,\n 4.5 ] }}");
  EXPECT_EQ(element_texts("{\"a\" : {\"b\":[ 1,\n 2e0 ] }}", {"a", "b"}),
            (std::vector<std::string>{"1", "2e0"}));
  EXPECT_EQ(with_elements("{\"b\": 7 ,\"c\":[1,2]}", {"b"}, {"3"}), "{\"b\": 3 ,\"c\":[1,2]}");
  EXPECT_EQ(element_texts("{\"b\": -7.50 ,\"c\":[1,2]}", {"b"}), std::vector<std::string>{"-7.50"});
  EXPECT_EQ(with_elements("{\"b\": 7 ,\"c\":[1 ,2]}", {"c"}, {"3", "4"}), "{\"b\": 7 ,\"c\":[3 ,4]}");
}

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

TEST(ScenarioChanges, NameEachPointerWithBothValuesAndAreEmptyWhereBothPlayTheSame) {
  const auto changes = [](const std::string& from, const std::string& to, const char* to_x = "400.5") {
    return scenario_changes(scenario_of("400", from), scenario_of(to_x, to));
  };
  EXPECT_EQ(changes("", "", "400.0"), "");
  EXPECT_EQ(changes("", R"(, "description": "another text")", "400"), "");
  const std::string two = std::string(kFling) + R"(, {"at_s": 0.5, "stop": {}})";
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
