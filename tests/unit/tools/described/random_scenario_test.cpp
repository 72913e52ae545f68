// Random scenarios of described cores.
#include "tools/described/random_scenario.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/unit/tools/described/pool_description.h"
#include "tools/described/scenario_json.h"

namespace hyrax {
namespace {

std::vector<DescribedScenario> library_of(const Description& description) {
  return {parse_described_scenario(description, R"({
    "format": "hyrax-scenario/1", "name": "a", "clock": {"rate_hz": 60}, "steps": 3,
    "start": {"mood": "calm", "a.x_px": 10, "pocketed": 0}, "inputs": {"push": [true, false, true]},
    "events": [{"step": 0, "hold": {}}, {"at_s": 0.01, "go": {}}, {"step": 2, "tint": {"shade": 7}}]})",
                                   "a.json")};
}

TEST(RandomScenario, IsOneThatAFileMayHold) {
  const Description pool = pool_description();
  const auto library = library_of(pool);
  std::set<std::size_t> kinds;
  for (std::uint64_t run = 0; run < 300; ++run) {
    const DescribedScenario scenario = random_scenario(pool, library, 7, run);
    EXPECT_EQ(parse_described_scenario(pool, to_text(to_json(pool, scenario)), "run"), scenario);
    EXPECT_EQ(random_scenario(pool, library, 7, run), scenario);
    for (const DescribedEvent& event : scenario.events) kinds.insert(event.action.index());
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<DescribedAction>);
}

TEST(RandomScenario, DrawsEachKindOfValueByItsRule) {
  Description pool = pool_description();
  pool.state.values.push_back(value_info<std::int32_t>("pose", 2));
  pool.state.values.back().is_enum = true;
  const auto library = library_of(pool);
  std::set<Word> moods, levels;
  double largest_px = 0.0;
  for (std::uint64_t run = 0; run < 500; ++run)
    for (const auto& [place, word] : random_scenario(pool, library, 1, run).start) {
      const std::string& name = pool.state.values[place].name;
      if (name == "mood") moods.insert(word);
      if (name == "level") levels.insert(word);
      if (name == "pose") {
        EXPECT_EQ(word, 2u);
      }
      if (name == "a.x_px") largest_px = std::max(largest_px, std::abs(value_of<double>(word)));
      if (name == "pocketed") {
        EXPECT_LE(std::abs(value_of<std::int32_t>(word)), 100);
      }
    }
  EXPECT_EQ(moods, (std::set<Word>{0, 1}));
  EXPECT_EQ(levels, (std::set<Word>{1, 2, 3, 4, 5}));
  EXPECT_GT(largest_px, 40.0);
  EXPECT_LE(largest_px, 80.0);
}

TEST(RandomScenario, AnEnumArgumentIsOneOfTheScenario) {
  Description pool = pool_description();
  pool.actions.push_back({"turn", {value_info<std::uint8_t>("side", 0), value_info("by_deg", 0.0)}});
  pool.actions.back().arguments.front().is_enum = true;
  std::vector<DescribedScenario> library = library_of(pool);
  const auto sides_drawn = [&] {
    std::multiset<Word> sides;
    for (std::uint64_t run = 0; run < 200; ++run)
      for (const DescribedEvent& event : random_scenario(pool, library, 1, run).events)
        if (const auto* const act = std::get_if<Act>(&event.action); act != nullptr && act->action == 3)
          sides.insert(act->arguments.front());
    return sides;
  };
  EXPECT_EQ(sides_drawn().size(), 0U) << "0 may be none of its values";
  library.front().events.push_back({std::int64_t{2}, Act{3, {2, word_of(90.0)}}});
  const std::multiset<Word> sides = sides_drawn();
  EXPECT_GT(sides.size(), 200U) << "at further times, too";
  EXPECT_EQ(sides.count(2), sides.size());
}

}  // namespace
}  // namespace hyrax
