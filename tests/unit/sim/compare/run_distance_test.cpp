// How far rows are apart, in energy too, and what is still rounding.
#include "sim/compare/run_distance.h"

#include <gtest/gtest.h>

#include <limits>

#include "sim/compare/comparison.h"

namespace hyrax {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Row kRow{.step = 7,
               .t_s = 0.5,
               .dt_s = 0.25,
               .x_px = 10.0,
               .y_px = 20.0,
               .vx_px_per_s = 0.0,
               .vy_px_per_s = 0.0,
               .contact = 8};

RunDistance distance_of(const Row& a, const Row& b) {
  RunDistance distance;
  distance.add(a, b);
  return distance;
}

bool is_rounding(double Row::*field, double difference) {
  Row other = kRow;
  other.*field += difference;
  return distance_of(kRow, other).is_rounding();
}

TEST(RunDistance, RoundingHasALimitForEveryQuantity) {
  for (const double sign : {1.0, -1.0}) {
    for (const auto field : {&Row::x_px, &Row::y_px, &Row::vx_px_per_s, &Row::vy_px_per_s}) {
      EXPECT_TRUE(is_rounding(field, sign * 0.99e-6));
      EXPECT_FALSE(is_rounding(field, sign * 1.01e-6));
    }
    for (const auto field : {&Row::t_s, &Row::dt_s}) {
      EXPECT_TRUE(is_rounding(field, sign * 0.99e-9));
      EXPECT_FALSE(is_rounding(field, sign * 1.01e-9));
    }
  }
}

TEST(RunDistance, AFastVelocityMayDifferByMore) {
  Row fast = kRow;
  fast.vx_px_per_s = -1e9;
  Row other = fast;
  other.vx_px_per_s -= 0.9e-3;
  EXPECT_TRUE(distance_of(fast, other).is_rounding());
  other.vx_px_per_s -= 0.2e-3;
  EXPECT_FALSE(distance_of(fast, other).is_rounding());
}

TEST(RunDistance, AnotherRestBitIsMoreThanRoundingAndNoOtherWall) {
  Row other = kRow;
  other.contact |= kRestBit;
  EXPECT_FALSE(distance_of(kRow, other).is_rounding());
  EXPECT_FALSE(distance_of(kRow, other).has_other_walls());
  other.contact |= static_cast<std::uint8_t>(Wall::left);
  EXPECT_TRUE(distance_of(kRow, other).has_other_walls());
  EXPECT_TRUE(distance_of(other, kRow).has_other_walls());
}

TEST(RunDistance, TheLargestIsTheFirstOfItsDistance) {
  RunDistance distance;
  for (const double offset_px : {0.0, 3.0, 5.0, -5.0, 1.0}) {
    Row a = kRow;
    Row b = kRow;
    b.x_px += offset_px;
    a.step = b.step = kRow.step + static_cast<std::int64_t>(offset_px);
    distance.add(a, b);
  }
  ASSERT_TRUE(distance.largest());
  EXPECT_EQ(distance.largest()->px, 5.0);
  EXPECT_EQ(distance.largest()->step, kRow.step + 5);
}

TEST(RunDistance, ANanIsInfinitelyFar) {
  Row other = kRow;
  other.x_px = kNan;
  const RunDistance distance = distance_of(kRow, other);
  ASSERT_TRUE(distance.largest());
  EXPECT_EQ(distance.largest()->px, kInfinity);
  EXPECT_FALSE(distance.is_rounding());
  EXPECT_FALSE(distance_of(other, other).is_rounding());
}

TEST(RunDistance, AnInfinityIsWithinRoundingOfItselfOnly) {
  Row fast = kRow;
  fast.vx_px_per_s = kInfinity;
  EXPECT_TRUE(distance_of(fast, fast).is_rounding());
  EXPECT_FALSE(distance_of(fast, kRow).is_rounding());
}

TEST(RunDistance, AContactsQuantitiesHaveTheSameLimits) {
  for (const ContactField& field : kContactFields) {
    const double limit = field.name == "contacts/t" ? 1e-9 : 1e-6;
    const Contact contact{.step = 3};
    Contact other = contact;
    RunDistance distance;
    other.*field.value = 0.99 * limit;
    distance.add(contact, other);
    EXPECT_TRUE(distance.is_rounding()) << field.name;
    other.*field.value = 1.01 * limit;
    distance.add(contact, other);
    EXPECT_FALSE(distance.is_rounding()) << field.name;
  }
}

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
