// Waypoints of long runs, from blocks that repeat, against those of every row.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/trajectory/waypoints.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

void expect_same(const Row& a, const Row& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_TRUE(same_bits(a.t_s, b.t_s));
  EXPECT_TRUE(same_bits(state_of(a), state_of(b)));
}

void expect_same_waypoints(const Scenario& scenario) {
  WaypointMeter blocks(step_count(scenario));
  WaypointMeter rows(0);  // Gets every row, as of a short run.
  replay(shipped_core(), scenario, {&blocks, &rows});
  const Waypoints a = blocks.take();
  const Waypoints b = rows.take();
  expect_same(a.apex, b.apex);
  ASSERT_EQ(a.at_seconds.size(), b.at_seconds.size());
  for (std::size_t second = 0; second < a.at_seconds.size(); ++second)
    expect_same(a.at_seconds[second], b.at_seconds[second]);
}

// The last two settle after 7 of 9 and 15 s; of those before a second ends with a block, or nearly.
TEST(WaypointsOfBlocks, AreThoseOfEveryRow) {
  for (const auto& [rate_hz, steps] : {std::pair{60.0, 20'000},
                                       {1000.0, 20'000},
                                       {2048.0, 24'576},
                                       {4095.0, 49'140},
                                       {4096.0, 49'152},
                                       {4097.0, 49'164},
                                       {8192.0, 98'304},
                                       {100'000.0, 900'000},
                                       {100'000.0, 1'500'000}}) {
    SCOPED_TRACE(rate_hz);
    expect_same_waypoints(fling_at(rate_hz, steps));
  }
}

TEST(WaypointsOfBlocks, TheApexMayComeLate) {
  expect_same_waypoints(fling_at(60.0, 20'000, {{std::int64_t{15'000}, Place{{700.0, -5.0}}}}));
}

}  // namespace
}  // namespace hyrax
