// The reference of the studies against motions whose impacts are known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/reference/exact_fling.h"

namespace hyrax {
namespace {

constexpr Bounds kBounds{1000.0, 1000.0};

// Without drag a drop from height h takes sqrt(2 h / g), and each bounce 0.6 of the one before.
FixedLaws without_drag() {
  Model model;
  model.air_drag = 1.0;
  return FixedLaws(model);
}

TEST(ExactFling, BouncesAsADropWithoutDragDoes) {
  ExactFling fling(without_drag());
  fling.start({500.0, 400.0, 0.0, 0.0}, kBounds);
  EXPECT_EQ(fling.at(10.0).y_px, 1000.0);
  const double fall_s = std::sqrt(2.0 * 600.0 / 1200.0);
  const double speed_px_per_s = 1200.0 * fall_s;
  double expected_s = fall_s;
  double left_px_per_s = 0.6 * speed_px_per_s;
  for (const ExactImpact& impact : fling.impacts()) {
    EXPECT_EQ(impact.wall, Wall::ground);
    EXPECT_NEAR(impact.t_s, expected_s, 1e-12);
    expected_s += 2.0 * left_px_per_s / 1200.0;
    left_px_per_s *= 0.6;
  }
  // 1200 * 0.6^n < 5 first for n = 11.
  EXPECT_EQ(fling.impacts().size(), 11u);
  EXPECT_EQ(fling.at(11.0).vy_px_per_s, 0.0);
}

TEST(ExactFling, AStartOutsideIsPutOntoItsWall) {
  ExactFling fling;
  fling.start({-50.0, 500.0, -100.0, 0.0}, kBounds);
  EXPECT_EQ(fling.at(0.0).x_px, 0.0);
  EXPECT_EQ(fling.at(0.0).vx_px_per_s, 60.0);
}

}  // namespace
}  // namespace hyrax
