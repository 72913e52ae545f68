#include "sim/reference/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/unit/sim/reference/wide.h"

namespace hyrax {
namespace {

constexpr double kGravity = 1200.0;

Wide position_at(const Approach& approach, const Wide& t) {
  WideMotion motion{approach.position_px, approach.speed_px_per_s};
  motion.fly(approach.acceleration_px_per_s2, Wide(approach.drag_rate_per_s) * t, t);
  return motion.displacement;
}

// The root between two times, inside at the first and outside at the second, by halving.
Wide true_time(const Approach& approach, Wide low, Wide high) {
  for (int i = 0; i < 80; ++i) {
    const Wide middle = (low + high) / 2.0;
    (position_at(approach, middle) < Wide(0.0) ? low : high) = middle;
  }
  return low;
}

struct Draw {
  explicit Draw(std::uint64_t seed) : random(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(random); }
  std::mt19937_64 random;
};

// A fall from below 1,000 px above the floor, thrown up or down; drag of 1 .. 1000 Hz or none.
Approach random_fall(Draw& draw) {
  return {-draw(0.1, 1000.0), draw(-2000.0, 2000.0), kGravity,
          draw(0.0, 1.0) < 0.1 ? 0.0 : std::pow(10.0, draw(-3.0, 0.0))};
}

// The goal is 1e-12; the closed form's rounding leaves a few units of 1.1e-16.
TEST(TimeOfImpact, OfAFallAgreesWith256Bits) {
  Draw draw(5);
  for (int i = 0; i < 300; ++i) {
    const Approach fall = random_fall(draw);
    const Wide truth = true_time(fall, Wide(std::max(0.0, -fall.speed_px_per_s) / kGravity / 2.0), 100.0);
    ASSERT_LT(std::fabs(((truth - time_of_impact(fall, 100.0)->t_s) / truth).rounded()), 1e-14) << i;
  }
}

TEST(TimeOfImpact, IsNoneForAWallThatIsNotMetInTheTimeGiven) {
  const Approach fall{-100.0, 0.0, kGravity, 0.06};
  const double t_s = time_of_impact(fall, 10.0)->t_s;
  EXPECT_TRUE(time_of_impact(fall, t_s * (1 + 1e-12)));
  EXPECT_FALSE(time_of_impact(fall, t_s * (1 - 1e-12)));
  // 0.6 px above at the turning point, inside before and after; below it.
  EXPECT_TRUE(time_of_impact({-149.4, 600.0, -kGravity, 0.0}, 1.0));
  EXPECT_FALSE(time_of_impact({-150.1, 600.0, -kGravity, 0.0}, 10.0));
  EXPECT_FALSE(time_of_impact({-0.0, -300.0, 0.0, 0.06}, 10.0)) << "it is left";
  const Impact on_the_wall = time_of_impact({0.0, 0.0, kGravity, 0.06}, 1.0).value();
  EXPECT_EQ(on_the_wall.t_s, 0.0);
  EXPECT_EQ(on_the_wall.speed_px_per_s, 0.0);
}

TEST(TimeOfImpact, OfASpeedTooSmallToDivideIsThatOfRest) {
  const double at_rest_s = time_of_impact({-100.0, 0.0, kGravity, 0.06}, 10.0)->t_s;
  EXPECT_EQ(time_of_impact({-100.0, -2.5e-323, kGravity, 0.06}, 10.0)->t_s, at_rest_s);
}

TEST(TimeOfImpact, IsFoundUnderTheDragOfABillionFramesASecond) {
  // Terminal speed g / k = 1.2e-3 px/s is reached at once: 1e-3 px take 0.83 s.
  const auto impact = time_of_impact({-1e-3, 0.0, kGravity, 1e6}, 10.0);
  ASSERT_TRUE(impact);
  EXPECT_NEAR(impact->t_s, 1e-3 / 1.2e-3, 1e-5);
}

}  // namespace
}  // namespace hyrax
