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

struct MemberRun {
  explicit MemberRun(const Scenario& scenario, bool skips = true) {
    summary = replay(kKicked, scenario, trace, {.skips_repetition = skips});
  }
  TraceSink trace;
  RunSummary summary;
};

TEST(FurtherMembers, GoOnFromStretchToStretchAndThroughAnAction) {
  const Event fling{std::int64_t{350}, Fling{{-1500.0, -900.0}}};
  for (const Scenario& scenario : {fling_at(60.0, 3000), fling_at(60.0, 800, {fling})})
    for (const bool skips : {true, false}) {  // It lies still before each kick.
      const MemberRun played(scenario, skips);
      Kicked body(300.0, 500.0, 2400.0, -700.0);
      for (const Row& row : played.trace.rows()) {
        if (row.step == 351 && !scenario.events.empty()) body.setVelocity(-1500.0, -900.0);
        if (row.step > 0) body.update(1.0 / 60.0, 1920, 1080, 128, 128);
        ASSERT_TRUE(same_bits(state_of(row), {body.x(), body.y(), body.vx(), body.vy()})) << row.step;
      }
      EXPECT_FALSE(played.summary.periodic_from_step);
    }
}

TEST(FurtherMembers, GoOnWhereARunIsResumed) {
  Scenario scenario = eventful_fling();
  scenario.length = std::int64_t{1500};
  const MemberRun whole(scenario);
  for (const std::int64_t step : {0, 1, 101, 699, 700, 1200}) {
    TraceSink first;
    Replay run(kKicked, scenario, {&first});
    run.play_to(step);
    TraceSink rest;
    Replay resumed(kKicked, scenario, run.keyframe(), rest);
    resumed.play_to(resumed.steps());
    resumed.finish();
    ASSERT_TRUE(same_row(rest.rows().back(), whole.trace.rows().back())) << "from " << step;
  }
}

}  // namespace
}  // namespace hyrax
