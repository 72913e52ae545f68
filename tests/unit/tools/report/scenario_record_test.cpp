#include "tools/report/wasm/scenario_record.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

TEST(ScenarioRecord, GivesEveryScenarioOfTheProjectAgain) {
  const auto paths = list_scenarios({std::string(HYRAX_SOURCE_DIR) + "/scenarios"});
  ASSERT_GT(paths.size(), 50u);
  for (const std::string& path : paths) {
    const Scenario scenario = load_scenario(path);
    const auto again = scenario_of(record_of(scenario));
    ASSERT_TRUE(again) << path;
    EXPECT_TRUE(plays_the_same(scenario, *again)) << path;
  }
}

Scenario jittered() {
  Scenario scenario;
  scenario.window = {1920, 1080};
  scenario.sprite = {128, 128};
  scenario.start_velocity = {-0.0, 1e12};
  scenario.clock.jitter = Jitter{Jitter::Kind::normal, 0.25, 0xFFFFFFFFFFFFFFFFu};
  scenario.length = std::int64_t{900};
  scenario.events = {{std::int64_t{3}, Resize{Size{0, 7}, std::nullopt}},
                     {0.5, Resize{std::nullopt, Size{5, 6}}},
                     {std::int64_t{40}, Resize{Size{1, 2}, Size{3, 4}}}};
  return scenario;
}

TEST(ScenarioRecord, KeepsEveryBitOfASeedAndTheSignOfZeroInAWholeRecordAndKnowsThePlaceOfAVariedNumber) {
  for (const auto& [pointer, place] : {std::pair("/window/height_px", 1u),
                                       {"/sprite/width_px", 2u},
                                       {"/start/x_px", 4u},
                                       {"/start/vy_px_per_s", 7u},
                                       {"/clock/jitter/seed", 16u}})
    EXPECT_EQ(place_in_record(jittered(), pointer), place) << pointer;
  std::vector<double> record = record_of(jittered());
  const auto again = scenario_of(record);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->clock.jitter->seed, 0xFFFFFFFFFFFFFFFFu);
  EXPECT_TRUE(std::signbit(again->start_velocity.vx_px_per_s));
  EXPECT_EQ(again->events, jittered().events);
  for (std::size_t length = 0; length < record.size(); ++length)
    EXPECT_FALSE(scenario_of(std::span<const double>(record).first(length))) << length;
  record.push_back(0.0);
  EXPECT_FALSE(scenario_of(record));
  record.pop_back();
  for (const std::size_t kind : {9u, 11u}) {  // Of the length, and of the clock.
    std::vector<double> unknown = record;
    unknown[kind] = 3.0;
    EXPECT_FALSE(scenario_of(unknown)) << kind;
  }
}

// The page writes a scenario file of this layout: record.js, and its test has the same numbers.
TEST(ScenarioRecord, HasTheLayoutThatThePageReads) {
  Scenario scenario;
  scenario.window = {800, 600};
  scenario.sprite = {64, 32};
  scenario.start = {1.0, 2.0};
  scenario.start_velocity = {3.0, 4.0};
  scenario.clock.base = RecordedSteps{{0.016, 0.017, -0.0}};
  scenario.events = {{std::int64_t{0}, Grab{}},
                     {std::int64_t{1}, Release{{10.0, 20.0}}},
                     {std::int64_t{1}, Place{{30.0, 40.0}}},
                     {std::int64_t{2}, Fling{{50.0, 60.0}}}};
  std::ostringstream record;
  for (const double number : record_of(scenario)) record << ", " << number;
  const std::string test = read_text_file(HYRAX_SOURCE_DIR "/tests/unit/tools/report/page_test.mjs");
  EXPECT_NE(test.find("const record = [" + record.str().substr(2) + "];"), std::string::npos) << record.str();
}

}  // namespace
}  // namespace hyrax
