// How far two runs are apart in energy.
#include "sim/compare/run_distance.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

constexpr double kGravity = 1200.0;

TEST(EnergyDifference, IsKineticAndPotential) {
  EnergyDifference energy(kGravity);
  EXPECT_FALSE(energy.largest());
  energy.add({.step = 3, .y_px = 100.0, .vx_px_per_s = 3.0, .vy_px_per_s = 4.0},
             {.step = 3, .y_px = 98.0, .vx_px_per_s = 5.0, .vy_px_per_s = 12.0});
  ASSERT_TRUE(energy.largest());
  EXPECT_DOUBLE_EQ(energy.largest()->px2_per_s2, (169.0 - 25.0) / 2.0 + 2.0 * kGravity);
  EXPECT_EQ(energy.largest()->step, 3);
}

TEST(EnergyDifference, KeepsTheLargestWithItsSign) {
  EnergyDifference energy(kGravity);
  for (const double fall_px : {1.0, 5.0, -2.0})
    energy.add({.step = static_cast<std::int64_t>(fall_px), .y_px = 0.0}, {.y_px = fall_px});
  EXPECT_DOUBLE_EQ(energy.largest()->px2_per_s2, -5.0 * kGravity);
  EXPECT_EQ(energy.largest()->step, 5);
}

TEST(EnergyDifference, DoesNotLoseSmallDifferencesOfLargeSpeeds) {
  EnergyDifference energy(kGravity);
  energy.add({.vx_px_per_s = 1e9}, {.vx_px_per_s = 1e9 + 0.25});
  EXPECT_DOUBLE_EQ(energy.largest()->px2_per_s2, 0.25 * 1e9 + 0.5 * 0.0625);
}

}  // namespace
}  // namespace hyrax
