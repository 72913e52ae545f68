// A core with members that no row shows.
#include <gtest/gtest.h>

#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/replay/replay.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

// Is kicked every so many steps.
struct Kicked : physics {
  using physics::physics;
  void update(double dt, int width, int height, int object_width, int object_height) {
    physics::update(dt, width, height, object_width, object_height);
    if (++steps % 700 == 0) setVelocity(vx() + 300.0, vy() - 500.0);
  }
  int steps = 0;
};

const Core kKicked = core_of<Kicked>("kicked", {});

// Counts to three, which matters as long as it rises.
struct Counting : physics {
  using physics::physics;
  void update(double dt, int width, int height, int object_width, int object_height) {
    physics::update(dt, width, height, object_width, object_height);
    phase = (phase + 1) % 3;
    if (phase == 0 && vy() < -200.0) setVelocity(vx() + 1.0, vy());
  }
  int phase = 0;
};

// A run against a body that is moved plainly. The scenario's events are flings.
template <class Body>
RunSummary expect_plain_run(const Core& core, const Scenario& scenario, bool skips) {
  TraceSink trace;
  const RunSummary summary = replay(core, scenario, trace, {.skips_repetition = skips});
  const auto [x_px, y_px, vx, vy] = start_state(scenario);
  Body body(x_px, y_px, vx, vy);
  for (const Row& row : trace.rows()) {
    for (const Event& event : scenario.events)
      if (row.step == std::get<std::int64_t>(event.when) + 1) {
        const Velocity& velocity = std::get<Fling>(event.action).velocity;
        body.setVelocity(velocity.vx_px_per_s, velocity.vy_px_per_s);
      }
    if (row.step > 0) body.update(1.0 / 60.0, 1920, 1080, 128, 128);
    EXPECT_TRUE(same_bits(state_of(row), {body.x(), body.y(), body.vx(), body.vy()})) << row.step;
  }
  return summary;
}

TEST(FurtherMembers, GoOnFromStretchToStretchAndThroughAnAction) {
  const Event fling{std::int64_t{350}, Fling{{-1500.0, -900.0}}};
  for (const Scenario& scenario : {fling_at(60.0, 3000), fling_at(60.0, 800, {fling})})
    for (const bool skips : {true, false})  // It lies still before each kick.
      EXPECT_FALSE(expect_plain_run<Kicked>(kKicked, scenario, skips).periodic_from_step);
}

TEST(FurtherMembers, GoOnInTheirPhaseWhereARunThatRepeatsGetsAnInput) {
  const Core counting = core_of<Counting>("counting", {});
  for (const std::int64_t frame : {500, 501, 502}) {
    Scenario scenario = fling_at(60.0, 900, {{frame, Fling{{-1500.0, -900.0}}}});
    scenario.start.y_px = 952.0;
    scenario.start_velocity = {};
    EXPECT_LT(expect_plain_run<Counting>(counting, scenario, true).steps_computed, 500);
  }
}

TEST(FurtherMembers, GoOnWhereARunIsResumed) {
  Scenario scenario = eventful_fling();
  scenario.length = std::int64_t{1500};
  TraceSink whole;
  replay(kKicked, scenario, whole);
  for (const std::int64_t step : {0, 1, 101, 699, 700, 1200}) {
    TraceSink first;
    Replay run(kKicked, scenario, {&first});
    run.play_to(step);
    TraceSink rest;
    Replay resumed(kKicked, scenario, run.keyframe(), rest);
    resumed.play_to(resumed.steps());
    resumed.finish();
    ASSERT_TRUE(same_row(rest.rows().back(), whole.rows().back())) << "from " << step;
  }
}

}  // namespace
}  // namespace hyrax
