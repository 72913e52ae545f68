// Waypoints of long runs, from blocks that repeat, against those of every row.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/waypoints.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

void expect_same(const Row& a, const Row& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_TRUE(same_bits(a.t_s, b.t_s));
  EXPECT_TRUE(same_bits(state_of(a), state_of(b)));
}

void expect_same_waypoints(const Scenario& scenario, std::int64_t steps) {
  WaypointMeter blocks(steps);
  WaypointMeter rows(0);  // Gets every row, as of a short run.
  replay(shipped_core(), scenario, {&blocks, &rows});
  const Waypoints a = blocks.take();
  const Waypoints b = rows.take();
  expect_same(a.apex, b.apex);
  ASSERT_EQ(a.at_seconds.size(), b.at_seconds.size());
  for (std::size_t second = 0; second < a.at_seconds.size(); ++second)
    expect_same(a.at_seconds[second], b.at_seconds[second]);
}

TEST(WaypointsOfBlocks, AreThoseOfEveryRow) {
  expect_same_waypoints(fling_at(60.0, 20'000), 20'000);
  expect_same_waypoints(fling_at(1000.0, 20'000), 20'000);
}

TEST(WaypointsOfBlocks, AreFoundInBlocksThatRepeat) {
  expect_same_waypoints(fling_at(100'000.0, 1'500'000), 1'500'000);  // 15 s, settled after 7.
}

TEST(WaypointsOfBlocks, AreFoundWhereASecondEndsWithABlock) {
  for (const double rate_hz : {2048.0, 4095.0, 4096.0, 4097.0, 8192.0})
    expect_same_waypoints(fling_at(rate_hz, static_cast<std::int64_t>(12 * rate_hz)),
                          static_cast<std::int64_t>(12 * rate_hz));
}

TEST(WaypointsOfBlocks, TheApexMayComeLate) {
  Scenario scenario = fling_at(60.0, 20'000, {{std::int64_t{15'000}, Place{{700.0, -5.0}}}});
  expect_same_waypoints(scenario, 20'000);
}

}  // namespace
}  // namespace hyrax
