#include "sim/reference/largest.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

namespace hyrax {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Larger, IsNanOnceOneIs) {
  EXPECT_EQ(larger(1.0, 2.0), 2.0);
  EXPECT_EQ(larger(2.0, 1.0), 2.0);
  EXPECT_TRUE(std::isnan(larger(kNaN, 1.0)));
  EXPECT_TRUE(std::isnan(larger(1.0, kNaN)));
}

double largest(std::initializer_list<double> differences) {
  LargestDistance distance;
  for (const double dx : differences) distance.add(dx, 0.0);
  return distance.value();
}

TEST(LargestDistance, KeepsANanAmongOtherValues) {
  EXPECT_EQ(largest({1.0, -3.0, 2.0}), 3.0);
  EXPECT_TRUE(std::isnan(largest({kNaN})));
  EXPECT_TRUE(std::isnan(largest({kNaN, 1.0})));
  EXPECT_TRUE(std::isnan(largest({1.0, kNaN})));
  EXPECT_TRUE(std::isnan(largest({1.0, kNaN, 1e200, 0.0})));
}

TEST(LargestDistance, NeitherVanishesNorRunsOver) {
  EXPECT_DOUBLE_EQ(distance(3e-170, 4e-170), 5e-170 * 0.0);
  EXPECT_DOUBLE_EQ(distance(3e-150, 4e-150), 5e-150);
  EXPECT_DOUBLE_EQ(distance(3e200, 4e200), 5e200);
  EXPECT_TRUE(std::isnan(distance(0.0, kNaN)));
}

}  // namespace
}  // namespace hyrax
