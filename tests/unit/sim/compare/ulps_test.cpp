// The distance of doubles in units in the last place.
#include "sim/compare/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hyrax {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

TEST(Ulps, AreNoneBetweenEqualValues) {
  for (const double value : {0.0, 1.0, -952.0, kSmallest, 1e300, kInfinity})
    EXPECT_EQ(ulps_between(value, value), 0u) << value;
  EXPECT_EQ(ulps_between(0.0, -0.0), 0u);
}

TEST(Ulps, CountNeighbours) {
  for (const double value : {1.0, 0.6, -1200.0, 4.9e-322, 1e-308, 952.0}) {
    EXPECT_EQ(ulps_between(value, std::nextafter(value, kInfinity)), 1u) << value;
    EXPECT_EQ(ulps_between(std::nextafter(value, -kInfinity), value), 1u) << value;
  }
}

TEST(Ulps, GoOnAcrossPowersOfTwoAndZero) {
  EXPECT_EQ(ulps_between(std::nextafter(2.0, 0.0), std::nextafter(2.0, 3.0)), 2u);
  EXPECT_EQ(ulps_between(-kSmallest, kSmallest), 2u);
  EXPECT_EQ(ulps_between(-0.0, kSmallest), 1u);
  EXPECT_EQ(ulps_between(1.0, 2.0), std::uint64_t{1} << 52);
}

TEST(Ulps, ReachFromEndToEnd) {
  constexpr std::uint64_t kPositive = 0x7FF0000000000000u;
  EXPECT_EQ(ulps_between(-kInfinity, kInfinity), 2 * kPositive);
  EXPECT_EQ(ulps_between(kInfinity, -kInfinity), 2 * kPositive);
  EXPECT_EQ(ulps_between(std::numeric_limits<double>::max(), kInfinity), 1u);
}

TEST(Ulps, AreNotDefinedForNan) {
  EXPECT_EQ(ulps_between(kNan, 1.0), std::nullopt);
  EXPECT_EQ(ulps_between(1.0, kNan), std::nullopt);
  EXPECT_EQ(ulps_between(kNan, kNan), std::nullopt);
}

}  // namespace
}  // namespace hyrax
