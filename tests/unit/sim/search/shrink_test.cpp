// Smaller scenarios play the rows that they are meant to keep, and shrinking finds the smallest that fails,
// the same one each time.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/search/random_scenario.h"
#include "sim/search/scenario_edit.h"
#include "sim/search/shrink.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

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

TEST(Shrink, WhatIsNeededIsKept) {
  Scenario scenario = eventful_fling();
  scenario.expect.emplace().finite = true;
  scenario.record_every = 7;
  const auto left = [&](const auto& fails) {
    return complexity_of(shrink(shipped_core(), scenario, fails).scenario);
  };
  EXPECT_EQ(left([](const Scenario& each) { return complexity_of(each).steps >= 37; }).steps, 37);
  EXPECT_EQ(left([](const Scenario& each) { return each.clock.jitter.has_value(); }),
            (Complexity{.steps = 0, .events = 0, .clock = 3, .digits = 5}));
  EXPECT_EQ(left([](const Scenario& each) { return each.expect.has_value(); }).extras, 1);
  EXPECT_EQ(left(meets_the_top).extras, 0);
  scenario.parameters = {{"AIR_DRAG", 0.9}, {"GRAVITY", 980.0}, {"REST_THRESHOLD", 7.0}};
  const auto has_gravity = [](const Scenario& each) {
    return std::ranges::any_of(each.parameters,
                               [](const Parameter& given) { return given.name == "GRAVITY"; });
  };
  EXPECT_EQ(shrink(shipped_core(), scenario, has_gravity).scenario.parameters.size(), 1u);
  scenario = fling_at(60.0, 0);
  scenario.clock = {RecordedSteps{{0.5, 0.01, 0.01, 0.01, 0.25}}, {}};
  scenario.length = std::monostate();
  const auto has_both_ends = [](const Scenario& each) {
    const auto* const trace = std::get_if<RecordedSteps>(&each.clock.base);
    return trace && trace->dt_s.size() > 1 && trace->dt_s.front() == 0.5 && trace->dt_s.back() == 0.25;
  };
  EXPECT_EQ(left(has_both_ends).steps, 2);
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

std::vector<Row> rows_of(const Scenario& scenario) {
  TraceSink rows;
  replay(shipped_core(), scenario, rows);
  return rows.rows();
}

Digest hash_of(const Scenario& scenario) { return replay(shipped_core(), scenario).state_hash; }

TEST(ScenarioEdit, PlainPlaysTheSame) {
  Scenario scenario = eventful_fling();
  scenario.schema = "../schema.json";
  EXPECT_EQ(hash_of(plain(scenario)), hash_of(scenario));
  EXPECT_EQ(plain(scenario).schema, std::nullopt) << "a path from another folder";
  scenario = fling_at(60.0, 0);
  scenario.length = 1.5;
  EXPECT_EQ(plain(scenario).length, (std::variant<std::monostate, std::int64_t, double>{std::int64_t{90}}));
}

TEST(ScenarioEdit, RecordedPlaysTheSame) {
  for (std::uint64_t run = 0; run < 200; ++run) {
    const Scenario scenario = plain(random_run(shipped_core(), 1, run).scenario);
    EXPECT_EQ(hash_of(recorded(scenario)), hash_of(scenario)) << scenario.name;
    EXPECT_TRUE(is_valid(recorded(scenario)));
  }
}

TEST(ScenarioEdit, AfterFramesTheOtherRowsAreTheSame) {
  const Scenario scenario = recorded(plain(eventful_fling()));
  const std::vector<Row> all = rows_of(scenario);
  for (const std::int64_t frames : {1, 50, 99, 103, 160, 190, 329}) {
    const Scenario later = after_frames(shipped_core(), scenario, frames);
    EXPECT_TRUE(is_valid(later)) << frames;
    const std::vector<Row> some = rows_of(later);
    ASSERT_EQ(some.size(), all.size() - static_cast<std::size_t>(frames));
    for (std::size_t row = 1; row < some.size(); ++row)
      EXPECT_TRUE(same_bits(state_of(all[row + static_cast<std::size_t>(frames)]), state_of(some[row])))
          << frames;
  }
}

TEST(ScenarioEdit, LaterEventsMoveWithTheirFrames) {
  const Scenario scenario = fling_at(60.0, 50, {{std::int64_t{5}, Stop{}}, {std::int64_t{40}, Stop{}}});
  const Scenario shorter = without_frames(scenario, 10, 30);
  EXPECT_EQ(step_count(shorter), 30);
  EXPECT_EQ(shorter.events, (std::vector<Event>{{std::int64_t{5}, Stop{}}, {std::int64_t{20}, Stop{}}}));
}

TEST(ScenarioEdit, AReleaseWithoutItsGrabIsAFling) {
  const Scenario scenario =
      fling_at(60.0, 50, {{std::int64_t{5}, Grab{}}, {std::int64_t{9}, Release{{1.0, 2.0}}}});
  const Scenario simpler = without_events(scenario, 0, 1);
  EXPECT_EQ(simpler.events, (std::vector<Event>{{std::int64_t{9}, Fling{{1.0, 2.0}}}}));
  EXPECT_TRUE(is_valid(simpler));
}

TEST(ScenarioEdit, WhatIsNotValidIsFound) {
  const Scenario good = fling_at(60.0, 50);
  EXPECT_TRUE(is_valid(good));
  const auto is_bad = [&](const auto& change) {
    Scenario changed = good;
    change(changed);
    return !is_valid(changed);
  };
  EXPECT_TRUE(is_bad([](Scenario& s) { s.window.width_px = -1; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.sprite.height_px = 0; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.start.x_px = 2e12; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.start_velocity.vy_px_per_s = std::nan(""); }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.clock.base = FixedRate{0.0}; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.clock.base = FixedStep{-1.0}; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.clock.base = RecordedSteps{}; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.clock.jitter = Jitter{Jitter::Kind::uniform, 1.5, 1}; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.events = {{std::int64_t{50}, Stop{}}}; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.events = {{std::int64_t{9}, Stop{}}, {std::int64_t{8}, Stop{}}}; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.events = {{std::int64_t{9}, Grab{}}, {std::int64_t{9}, Grab{}}}; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.events = {{std::int64_t{9}, Release{}}}; }));
  EXPECT_TRUE(is_bad([](Scenario& s) { s.events = {{std::int64_t{9}, Hitch{2e9}}}; }));
}

}  // namespace
}  // namespace hyrax
