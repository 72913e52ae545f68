// A stuck vx is not computed, and nothing shows it: bits, contacts and summary are those of class physics
// called for every frame.
#include "sim/core/shipped_core.h"
#include "sim/core/stepper_of.h"

#include <gtest/gtest.h>

#include "sim/core/core.h"
#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/physics_model.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

constexpr double kUnit = std::numeric_limits<double>::denorm_min();

// Class physics; counts updates with a subnormal vx.
struct CountingPhysics : physics {
  using physics::physics;
  void update(double dt_s, int window_width, int window_height, int width, int height) {
    if (std::fpclassify(vx()) == FP_SUBNORMAL) ++subnormal_updates;
    physics::update(dt_s, window_width, window_height, width, height);
  }
  static inline std::int64_t subnormal_updates = 0;
};

// Said to be the listing, or not.
Core counting_core(bool is_listing) {
  return core_of<CountingPhysics>(kPhysicsModel, {.is_listing = is_listing});
}

struct PlayedSlide {
  PlayedSlide(const Scenario& scenario, const Core& core) {
    CountingPhysics::subnormal_updates = 0;
    summary = text_of(replay(core, scenario, trace, {.checks_bounds = true}));
    subnormal_updates = CountingPhysics::subnormal_updates;
  }
  TraceSink trace;
  std::string summary;
  std::int64_t subnormal_updates = 0;
};

testing::AssertionResult same_played(const PlayedSlide& a, const PlayedSlide& b) {
  if (a.summary != b.summary) return testing::AssertionFailure() << a.summary << "\nis not\n" << b.summary;
  return same_trace(a.trace, b.trace);
}

Scenario jittered(double rate_hz, std::int64_t steps, Jitter jitter) {
  Scenario scenario = fling_at(rate_hz, steps);
  scenario.clock.jitter = jitter;
  return scenario;
}

// Starts in which a speed is stuck, or nearly: on, beside and far from the bounds, on the floor and above it,
// in frames that are short and so long that a unit of vx moves a sprite at 0.
std::vector<Scenario> edge_cases() {
  std::vector<Scenario> scenarios;
  for (const double rate_hz : {0.5, 3.9, 60.0, 1000.0})
    for (const double units : {1.0, 2.0, 3.0, 4.0, 500.0, 501.0, 1e6})
      for (const double sign : {-1.0, 1.0})
        for (const double x_px : {0.0, -0.0, kUnit, 4.0 * kUnit, 1e-300, 700.0, 1792.0, 1793.0, -1.0})
          for (const double y_px : {952.0, 940.0}) {
            Scenario scenario = jittered(rate_hz, 40, {Jitter::Kind::uniform, 0.9, 3});
            scenario.start = {x_px, y_px};
            scenario.start_velocity = {sign * units * kUnit, 0.0};
            scenarios.push_back(scenario);
          }
  return scenarios;
}

TEST(StuckSpeed, EdgeCasesHaveTheBitsOfEveryStep) {
  const Core every_step = counting_core(false);
  const Core skipping = counting_core(true);
  std::int64_t skipped = 0;
  for (const Scenario& scenario : edge_cases()) {
    const PlayedSlide slow(scenario, every_step), fast(scenario, skipping);
    EXPECT_TRUE(same_played(fast, slow)) << scenario.start_velocity.vx_px_per_s << " " << scenario.start.x_px;
    EXPECT_TRUE(same_played(PlayedSlide(scenario, shipped_core()), slow));
    skipped += slow.subnormal_updates > 0 && fast.subnormal_updates == 0 ? 1 : 0;
  }
  EXPECT_GT(skipped, 50);
}

TEST(StuckSpeed, IsLeftOutOnceARunHasIt) {
  for (const Jitter jitter : {Jitter{Jitter::Kind::uniform, 0.2, 1}, Jitter{Jitter::Kind::normal, 0.003, 2},
                              Jitter{Jitter::Kind::missed_frames, 0.1, 3}}) {
    Scenario scenario = jittered(60.0, 30'000, jitter);
    const auto at = [](std::int64_t frame, Action action) { return Event{frame, action}; };
    scenario.events = {at(12'000, Resize{Size{1000, 700}, {}}), at(14'000, Grab{}),
                       at(14'100, Release{{0.0, -300.0}}), at(14'500, Fling{{-3.0, -500.0}}),
                       at(20'000, Hitch{1e9})};
    const PlayedSlide slow(scenario, counting_core(false)), fast(scenario, counting_core(true));
    EXPECT_TRUE(same_played(fast, slow));
    EXPECT_TRUE(same_played(PlayedSlide(scenario, shipped_core()), slow));
    EXPECT_GT(slow.subnormal_updates, 15'000);
    EXPECT_LT(fast.subnormal_updates, 10'000);
  }
}

}  // namespace
}  // namespace hyrax
