// Random scenarios: valid, reproducible, of every feature; and no rule broken by the shipped core.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "sim/core/kernel_of.h"
#include "sim/core/shipped_core.h"
#include "sim/motion/displays.h"
#include "sim/physics/physics.h"
#include "sim/scenario/frame_clock.h"
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

TEST(RandomRun, IsTheSameWheneverItIsDrawn) {
  const RandomRun one = random_run(shipped_core(), 5, 17);
  static_cast<void>(random_run(shipped_core(), 5, 18));
  const RandomRun again = random_run(shipped_core(), 5, 17);
  EXPECT_TRUE(plays_the_same(one.scenario, again.scenario));
  EXPECT_EQ(one.stops, again.stops);
  EXPECT_EQ(one.scenario.name, "fuzz-5-17");
  EXPECT_FALSE(plays_the_same(one.scenario, random_run(shipped_core(), 6, 17).scenario));
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

TEST(RandomRun, StartsAsItsFeaturesSay) {
  int outside = 0, fast = 0, on_bounds = 0, leaving_the_threshold = 0;
  std::int64_t longest = 0;
  for (std::uint64_t run = 0; run < 2000; ++run) {
    const RandomRun random = random_run(shipped_core(), 2, run);
    const auto has = [&random](Feature feature) {
      return random.features[static_cast<std::size_t>(feature)];
    };
    const Scenario& scenario = random.scenario;
    const Bounds bounds = bounds_of(scenario.window, scenario.sprite);
    const Position& start = scenario.start;
    const Velocity& velocity = scenario.start_velocity;
    const double speed_px_per_s = std::max(std::fabs(velocity.vx_px_per_s), std::fabs(velocity.vy_px_per_s));
    if (has(Feature::corners)) {  // It moves towards the walls that are near.
      EXPECT_NEAR(start.x_px, std::signbit(velocity.vx_px_per_s) ? 10.0 : bounds.right_px - 10.0, 10.001);
      EXPECT_NEAR(start.y_px, std::signbit(velocity.vy_px_per_s) ? 10.0 : bounds.bottom_px - 10.0, 10.001);
    } else {
      if (has(Feature::rest)) {
        EXPECT_EQ(start.y_px, bounds.bottom_px);
        const double dt_s = FrameClock(scenario.clock).dt_s(0);
        leaving_the_threshold += velocity.vy_px_per_s == 5.0 / 0.6 / 0.999 - 1200.0 * dt_s ? 1 : 0;
      }
      on_bounds += has(Feature::on_bounds) && (start.x_px == 0.0 || start.x_px == bounds.right_px) ? 1 : 0;
      const bool is_outside = std::fabs(start.x_px) > 1e4;
      EXPECT_LE(is_outside, has(Feature::outside));
      outside += is_outside ? 1 : 0;
    }
    EXPECT_LE(speed_px_per_s > 2500.0, has(Feature::fast) || has(Feature::rest));
    fast += speed_px_per_s > 2500.0 ? 1 : 0;
    EXPECT_LE(has(Feature::small_window),
              std::max(scenario.window.width_px, scenario.window.height_px) <= 64);
    const std::int64_t steps = step_count(scenario);
    EXPECT_LE(steps, has(Feature::long_run) ? 2000 : 80);
    longest = std::max(longest, steps);
  }
  EXPECT_GT(outside, 50);
  EXPECT_GT(fast, 100);
  EXPECT_GT(on_bounds, 100);
  EXPECT_GT(leaving_the_threshold, 50);
  EXPECT_GT(longest, 1500);
}

TEST(RandomRun, IsPlayedOnEachDisplayAtEachRate) {
  std::set<std::pair<std::int32_t, double>> drawn;
  for (std::uint64_t run = 0; run < 40'000; ++run) {
    const Scenario scenario = random_run(shipped_core(), 7, run).scenario;
    const auto* const rate = std::get_if<FixedRate>(&scenario.clock.base);
    if (rate != nullptr) drawn.emplace(scenario.window.width_px, rate->rate_hz);
  }
  for (const Size& display : kDisplays)
    for (const double rate_hz : kDisplayRates_hz)
      EXPECT_TRUE(drawn.contains({display.width_px, rate_hz})) << display.width_px << " at " << rate_hz;
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
  const Core core{.kernel = std::make_shared<const KernelOf<LeakingCores>>()};
  for (const auto& [kick_at, broken] : {std::pair(250, Invariant::repeated), {450, Invariant::resumed}}) {
    Leaking::steps = 0;
    Leaking::kick_at = kick_at;
    const InvariantMeasures measures = check_run(core, scenario, std::array{std::int64_t{100}}).measures;
    for (const Invariant each : {Invariant::repeated, Invariant::resumed})
      EXPECT_EQ(measures[static_cast<std::size_t>(each)].holds, each != broken);
    EXPECT_EQ(first_broken(scenario, measures), broken);
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
