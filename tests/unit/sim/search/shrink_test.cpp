// Shrinking finds the smallest scenario that fails, the same one each time.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/search/random_scenario.h"
#include "sim/search/scenario_edit.h"
#include "sim/search/shrink.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

bool meets_the_top(const Scenario& scenario) { return replay(shipped_core(), scenario).contacts.top > 0; }
bool has_a_stop(const Scenario& scenario) {
  return std::any_of(scenario.events.begin(), scenario.events.end(),
                     [](const Event& event) { return std::holds_alternative<Stop>(event.action); });
}

TEST(Shrink, OneFrameIsLeftOfARunThatMeetsTheTop) {
  const Shrunk shrunk = shrink(shipped_core(), eventful_fling(), meets_the_top);
  EXPECT_TRUE(meets_the_top(shrunk.scenario));
  EXPECT_TRUE(shrunk.is_complete);
  const Complexity left = complexity_of(shrunk.scenario);
  EXPECT_EQ(left.steps, 1);
  EXPECT_EQ(left.events, 0);
  EXPECT_EQ(left.clock, 0);
  EXPECT_LE(left.digits, 6);
}

TEST(Shrink, OneEventIsLeftWhereOneIsNeeded) {
  const Shrunk shrunk = shrink(shipped_core(), eventful_fling(), has_a_stop);
  EXPECT_EQ(shrunk.scenario.events, (std::vector<Event>{{std::int64_t{0}, Stop{}}}));
  EXPECT_EQ(complexity_of(shrunk.scenario).steps, 1);
  EXPECT_EQ(shrunk.scenario.window, (Size{1000, 1000}));  // None is without a side.
  EXPECT_EQ(shrunk.scenario.sprite, (Size{100, 100}));
}

TEST(Shrink, WhatNeedsManyFramesKeepsThem) {
  const auto is_long = [](const Scenario& scenario) { return complexity_of(scenario).steps >= 37; };
  EXPECT_EQ(complexity_of(shrink(shipped_core(), eventful_fling(), is_long).scenario).steps, 37);
}

TEST(Shrink, WhatNeedsJitterKeepsIt) {
  const auto is_jittered = [](const Scenario& scenario) { return scenario.clock.jitter.has_value(); };
  const Shrunk shrunk = shrink(shipped_core(), eventful_fling(), is_jittered);
  EXPECT_EQ(complexity_of(shrunk.scenario), (Complexity{.steps = 0, .events = 0, .clock = 3, .digits = 5}))
      << complexity_of(shrunk.scenario).digits;
}

TEST(Shrink, WhatNeedsItsExpectationsKeepsThem) {
  Scenario scenario = eventful_fling();
  scenario.expect.emplace().finite = true;
  scenario.record_every = 7;
  const auto expects = [](const Scenario& each) { return each.expect.has_value(); };
  EXPECT_EQ(complexity_of(shrink(shipped_core(), scenario, expects).scenario).extras, 1);
  EXPECT_EQ(complexity_of(shrink(shipped_core(), scenario, meets_the_top).scenario).extras, 0);
}

TEST(Shrink, IsDeterministicAndOfRandomRunsAsWell) {
  for (std::uint64_t run = 0; run < 40; ++run) {
    const Scenario scenario = random_run(shipped_core(), 9, run).scenario;
    if (!meets_the_top(scenario)) continue;
    const Shrunk one = shrink(shipped_core(), scenario, meets_the_top);
    const Shrunk again = shrink(shipped_core(), scenario, meets_the_top);
    EXPECT_TRUE(meets_the_top(one.scenario));
    EXPECT_LE(complexity_of(one.scenario).steps, 1) << scenario.name;
    EXPECT_TRUE(plays_the_same(one.scenario, again.scenario));
    EXPECT_EQ(one.trials, again.trials);
  }
}

TEST(Shrink, WhatDoesNotFailIsReturnedAsItIs) {
  const Scenario scenario = eventful_fling();
  const Shrunk shrunk = shrink(shipped_core(), scenario, [](const Scenario&) { return false; });
  EXPECT_TRUE(plays_the_same(shrunk.scenario, scenario));
  EXPECT_FALSE(shrunk.fails_again);
  EXPECT_EQ(shrunk.trials, 1);
}

TEST(Shrink, StopsAtTheLimitOfTrials) {
  const Shrunk shrunk = shrink(shipped_core(), eventful_fling(), meets_the_top, {.trials_max = 5});
  EXPECT_EQ(shrunk.trials, 5);
  EXPECT_FALSE(shrunk.is_complete);
  EXPECT_TRUE(meets_the_top(shrunk.scenario));
}

TEST(Numbers, DigitsAreThoseOfTheShortestText) {
  Scenario scenario;
  scenario.window = {1920, 1000};
  scenario.sprite = {1, 20};
  scenario.start = {0.0, 1e9};
  scenario.start_velocity = {-12.5, 0.001};
  scenario.clock.base = FixedRate{59.94};
  EXPECT_EQ(digits_of(scenario), 3 + 1 + 1 + 1 + 0 + 1 + 3 + 1 + 4);
}

TEST(Numbers, AreRoundedToSoManyDigits) {
  Scenario scenario = fling_at(60.0, 1);
  scenario.start.x_px = -123.456;
  const auto rounded = [&](std::size_t index, int digits) {
    Scenario copy = scenario;
    round_to(numbers_of(copy)[index], digits);
    return copy;
  };
  EXPECT_EQ(rounded(0, 2).window.width_px, 1900);
  EXPECT_EQ(rounded(0, 9).window.width_px, 1920);
  EXPECT_EQ(rounded(0, 0).window.width_px, 0);
  EXPECT_EQ(rounded(4, 4).start.x_px, -123.5);
  EXPECT_EQ(rounded(4, 1).start.x_px, -100.0);
  EXPECT_EQ(rounded(4, 17).start.x_px, -123.456);
  EXPECT_EQ(rounded(4, 0).start.x_px, 0.0);
}

}  // namespace
}  // namespace hyrax
