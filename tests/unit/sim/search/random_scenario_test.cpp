// Random scenarios: valid, reproducible, of every feature; and no rule broken by the shipped core.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "sim/core/shipped_core.h"
#include "sim/core/stepper_of.h"
#include "sim/physics/physics.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/split_mix64.h"
#include "sim/search/random_scenario.h"
#include "sim/search/run_check.h"
#include "sim/search/scenario_edit.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {
namespace {

TEST(RandomRun, IsAValidScenarioThatItsFileGivesBack) {
  for (std::uint64_t run = 0; run < 2000; ++run) {
    const Scenario scenario = random_run(shipped_core(), 3, run).scenario;
    EXPECT_TRUE(is_valid(scenario)) << scenario.name;
    EXPECT_TRUE(plays_the_same(scenario, parse_scenario(scenario_file_text(scenario), scenario.name)));
  }
}

// Features, stops and scenarios, whatever was drawn before.
TEST(RandomRun, IsThatOfItsNumber) {
  std::uint64_t digest = 0;
  for (std::uint64_t run = 0; run < 2000; ++run) {
    const RandomRun random = random_run(shipped_core(), 2, run);
    std::string text = random.features.to_string() + scenario_file_text(random.scenario);
    for (const std::int64_t stop : random.stops) text += " " + std::to_string(stop);
    for (const char letter : text) digest = split_mix64(digest, static_cast<unsigned char>(letter));
  }
  EXPECT_EQ(digest, 9011392166195519378u);
}

TEST(RandomFling, IsTenSecondsOnADisplayWithoutEvents) {
  std::set<double> rates_hz;
  int jittered = 0, outside = 0;
  for (std::uint64_t number = 0; number < 500; ++number) {
    const Scenario fling = random_fling(shipped_core(), 1, number);
    EXPECT_TRUE(is_valid(fling)) << fling.name;
    EXPECT_TRUE(fling.events.empty());
    const double rate_hz = std::get<FixedRate>(fling.clock.base).rate_hz;
    EXPECT_EQ(static_cast<double>(step_count(fling)), 10.0 * rate_hz);
    rates_hz.insert(rate_hz);
    jittered += fling.clock.jitter ? 1 : 0;
    outside += fling.start.x_px < 0.0 ? 1 : 0;
  }
  EXPECT_EQ(*rates_hz.begin(), 24.0);
  EXPECT_EQ(*rates_hz.rbegin(), 360.0);
  EXPECT_EQ(rates_hz.size(), 16u);
  EXPECT_NEAR(jittered, 250, 50);
  EXPECT_GT(outside, 0);
  EXPECT_EQ(random_fling(shipped_core(), 1, 7), random_fling(shipped_core(), 1, 7));
  EXPECT_NE(random_fling(shipped_core(), 1, 7).start, random_fling(shipped_core(), 2, 7).start);
}

// What the features are for comes about: each kind of action, jitter and clock, and sizes that do not fit.
TEST(RandomRun, ReachesWhatTheFormatAllows) {
  std::set<std::size_t> actions, clocks, jitters;
  int oversized = 0, zero_frames = 0;
  for (std::uint64_t run = 0; run < 1000; ++run) {
    const Scenario scenario = random_run(shipped_core(), 2, run).scenario;
    for (const Event& event : scenario.events) actions.insert(event.action.index());
    clocks.insert(scenario.clock.base.index());
    if (scenario.clock.jitter) jitters.insert(static_cast<std::size_t>(scenario.clock.jitter->kind));
    oversized += scenario.sprite.width_px > scenario.window.width_px ? 1 : 0;
    const FrameClock clock(scenario.clock);
    for (std::int64_t frame = 0; frame < step_count(scenario); ++frame)
      if (clock.dt_s(frame) == 0.0) {
        ++zero_frames;
        break;
      }
  }
  EXPECT_EQ(actions.size(), std::variant_size_v<Action>);
  EXPECT_EQ(clocks.size(), 3u);
  EXPECT_EQ(jitters.size(), 3u);
  EXPECT_GT(oversized, 50);
  EXPECT_GT(zero_frames, 50);
}

// Is kicked once, by a count of the steps of all runs.
struct Leaking : physics {
  using physics::physics;
  void update(double dt, int width, int height, int object_width, int object_height) {
    physics::update(dt, width, height, object_width, object_height);
    if (++steps == kick_at) setVelocity(vx() + 300.0, vy());
  }
  static inline int steps = 0, kick_at = 0;
};
struct LeakingCores {
  using Core = Leaking;
  [[nodiscard]] Leaking make(const State& s) const { return {s.x_px, s.y_px, s.vx_px_per_s, s.vy_px_per_s}; }
};

TEST(CheckRun, ComparesWithASecondRunAndWithOneThatIsResumed) {
  const Scenario scenario = fling_at(60.0, 200);
  const Core core{.stepper = std::make_shared<const StepperOf<LeakingCores>>()};
  for (const auto& [kick_at, broken] : {std::pair(250, Invariant::repeated), {450, Invariant::resumed}}) {
    Leaking::steps = 0;
    Leaking::kick_at = kick_at;
    const InvariantMeasures measures = check_run(core, scenario, std::array{std::int64_t{100}}).measures;
    for (const Invariant each : {Invariant::repeated, Invariant::resumed})
      EXPECT_EQ(measures[static_cast<std::size_t>(each)].holds, each != broken);
    EXPECT_EQ(broken_invariants(scenario, measures), std::vector{broken});
  }
}

TEST(CheckRun, TheListingBreaksTheMirrorOnlyWhereTheSpriteIsWiderThanItsWindow) {
  Scenario scenario = random_run(shipped_core(), 1, 0).scenario;
  scenario.window = {100, 10};
  scenario.sprite = {100, 200};
  scenario.events.clear();
  EXPECT_FALSE(is_broken_by_listing(Invariant::mirror, scenario));
  scenario.events = {{std::int64_t{3}, Resize{Size{99, 10}, {}}}};
  EXPECT_TRUE(is_broken_by_listing(Invariant::mirror, scenario));
  EXPECT_FALSE(is_broken_by_listing(Invariant::speed, scenario));
  scenario.events.clear();
  scenario.sprite.width_px = 101;
  EXPECT_TRUE(is_broken_by_listing(Invariant::mirror, scenario));
}

}  // namespace
}  // namespace hyrax
