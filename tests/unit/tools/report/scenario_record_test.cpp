#include "tools/report/wasm/scenario_record.h"

#include <gtest/gtest.h>

#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"

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

TEST(ScenarioRecord, KeepsEveryBitOfASeedAndTheSignOfZero) {
  const auto again = scenario_of(record_of(jittered()));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->clock.jitter->seed, 0xFFFFFFFFFFFFFFFFu);
  EXPECT_TRUE(std::signbit(again->start_velocity.vx_px_per_s));
  EXPECT_EQ(again->events, jittered().events);
}

TEST(ScenarioRecord, RefusesARecordThatIsCutShortOrTooLong) {
  std::vector<double> record = record_of(jittered());
  for (std::size_t length = 0; length < record.size(); ++length)
    EXPECT_FALSE(scenario_of(std::span<const double>(record).first(length))) << length;
  record.push_back(0.0);
  EXPECT_FALSE(scenario_of(record));
}

}  // namespace
}  // namespace hyrax
