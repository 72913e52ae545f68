#include "sim/reference/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/unit/sim/reference/wide.h"

namespace hyrax {
namespace {

constexpr double kGravity = 1200.0;

struct Errors {
  double position = 0.0;  // Of |v| t + g t^2 / 2.
  double speed = 0.0;     // Of |v| + g t.
};

Errors errors_of(const AxisMotion& motion, double v, double k, double t) {
  WideMotion truth{0.0, v};
  truth.fly(kGravity, Wide(k) * t, t);
  return {std::fabs((truth.displacement - motion.displacement_px).rounded()) /
              (std::fabs(v) * t + kGravity * t * t / 2),
          std::fabs((truth.speed - motion.speed_px_per_s).rounded()) / (std::fabs(v) + kGravity * t)};
}

// Random arcs up to 100 s, from no drag to the drag of a million frames a second.
Errors worst_of_random_arcs() {
  std::mt19937_64 random(2);
  Errors worst;
  for (int i = 0; i < 20'000; ++i) {
    const double v = std::uniform_real_distribution<>(-5000.0, 5000.0)(random);
    const double t = 100.0 * std::pow(10.0, std::uniform_real_distribution<>(-4.0, 0.0)(random));
    const double k = std::pow(10.0, std::uniform_real_distribution<>(-15.0, 3.0)(random));
    const Errors errors = errors_of(fly(v, kGravity, k, t), v, k, t);
    worst = {std::max(worst.position, errors.position), std::max(worst.speed, errors.speed)};
  }
  return worst;
}

// A dozen roundings, 1.1e-16 each; the goal is 1e-14.
TEST(ContinuousClosedForm, AgreesWith256BitsOverAHundredSeconds) {
  const Errors worst = worst_of_random_arcs();
  EXPECT_LT(worst.position, 2e-15);
  EXPECT_LT(worst.speed, 2e-15);
}

TEST(ContinuousClosedForm, IsAParabolaWithoutDrag) {
  const AxisMotion motion = fly(-900.0, kGravity, 0.0, 2.0);
  EXPECT_EQ(motion.displacement_px, -900.0 * 2.0 + kGravity * 2.0);
  EXPECT_EQ(motion.speed_px_per_s, -900.0 + kGravity * 2.0);
}

}  // namespace
}  // namespace hyrax
