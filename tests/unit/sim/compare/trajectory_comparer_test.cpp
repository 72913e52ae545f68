// Two recorded trajectories within tolerances.
#include "sim/compare/trajectory_comparer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hyrax {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Tolerance, IsInclusiveAndMetWhereAnyOfThemIs) {
  EXPECT_TRUE(Tolerance{}.is_exact());
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  constexpr double kLargest = std::numeric_limits<double>::max();
  const Tolerance exact, any{.abs = 1e-6, .rel = 1e-3, .ulps = 0},
      wide{.abs = 1e300, .rel = 1.0, .ulps = std::numeric_limits<std::int64_t>::max()};
  const struct {
    Tolerance tolerance;
    double a, b;
    bool is_accepted;
  } cases[] = {
      {exact, 1.5, 1.5, true},
      {exact, kInfinity, kInfinity, true},
      {exact, 1.5, std::nextafter(1.5, 2.0), false},
      {exact, 0.0, -0.0, false},
      {{.abs = 0.5}, 10.0, 10.5, true},
      {{.abs = 0.5}, 10.0, 10.75, false},
      {{.rel = 0.5}, -4.0, -2.0, true},
      {{.rel = 0.5}, 4.0, 1.5, false},
      {{.ulps = 1}, 1.0, std::nextafter(1.0, 2.0), true},
      {{.ulps = 1}, 1.0, 1.0 + 4e-16, false},
      // Of zero: zeros of either sign.
      {{.abs = 0.0}, 0.0, -0.0, true},
      {{.rel = 0.0}, 0.0, -0.0, true},
      {{.ulps = 0}, 0.0, -0.0, true},
      {any, 1e-9, -1e-9, true},
      {any, 1000.0, 1000.5, true},
      {any, 1.0, 1.1, false},
      // Never a NaN, and of infinities equal ones only.
      {wide, kNan, kNan, false},
      {wide, kNan, 1.0, false},
      {wide, 1.0, kNan, false},
      {wide, -kInfinity, -kInfinity, true},
      {wide, 1.0, kInfinity, false},
      {wide, -kInfinity, 1.0, false},
      {wide, -kInfinity, kInfinity, false},
      {wide, kLargest, kInfinity, false},
      // Of the larger magnitude where the difference overflows.
      {{.rel = 1.9}, 1.5e308, -1.5e308, false},
      {{.rel = 2.0}, 1.5e308, -1.5e308, true},
      {{.abs = 1e308}, 1.5e308, -1.5e308, false},
      {{.rel = 0.25}, kSmallest, 0.0, false},
      {{.rel = 0.25}, kSmallest, -kSmallest, false},
      {{.ulps = 2}, kSmallest, -kSmallest, true},
  };
  for (const auto& [tolerance, a, b, is_accepted] : cases)
    EXPECT_EQ(tolerance.accepts(a, b), is_accepted) << a << ", " << b;
}

// All of these numbers are exact, so the relative difference is exactly 2^-10.
TEST(Tolerance, IsInclusiveForNumbersOfAnySize) {
  for (int kilo = 1; kilo <= 100; ++kilo) {
    const double larger = 1024.0 * kilo;
    EXPECT_TRUE((Tolerance{.rel = 0x1p-10}.accepts(larger, larger - kilo))) << larger;
    EXPECT_FALSE((Tolerance{.rel = 0x1p-10}.accepts(larger, larger - kilo - 0x1p-20))) << larger;
  }
}

Row row_at(std::int64_t step, double x_px, std::uint8_t contact = 0) {
  return {.step = step, .t_s = 0.25 * static_cast<double>(step), .x_px = x_px, .contact = contact};
}

TEST(TrajectoryComparer, ReportsTheFirstAndTheWorstWithinTheToleranceToo) {
  TrajectoryComparer comparer({});
  comparer.compare(row_at(0, 1.0), row_at(0, 1.0));
  EXPECT_FALSE(comparer.first());
  for (const auto& none : comparer.worst()) EXPECT_FALSE(none);
  comparer.compare(row_at(1, 1.0), row_at(1, 1.5));
  comparer.compare(row_at(2, 1.0), row_at(2, 4.0));
  comparer.compare(row_at(3, 1.0), row_at(3, 2.0));
  ASSERT_TRUE(comparer.first());
  EXPECT_EQ(comparer.first()->step, 1);
  EXPECT_EQ(comparer.first()->field, "x");
  EXPECT_EQ(comparer.first()->expected, 1.0);
  EXPECT_EQ(comparer.first()->actual, 1.5);
  const auto& worst = comparer.worst()[2];
  ASSERT_TRUE(worst);
  EXPECT_EQ(worst->step, 2);
  EXPECT_EQ(worst->abs(), 3.0);
  TrajectoryComparer tolerant({.abs = 1.0});
  tolerant.compare(row_at(5, 1.0), row_at(5, 1.5));
  EXPECT_FALSE(tolerant.first());
  ASSERT_TRUE(tolerant.worst()[2]);
  EXPECT_EQ(tolerant.worst()[2]->abs(), 0.5);
}

TEST(TrajectoryComparer, RanksNanAsTheWorst) {
  TrajectoryComparer comparer({.abs = 1e9});
  comparer.compare(row_at(1, 1.0), row_at(1, 1e6));
  comparer.compare(row_at(2, kNan), row_at(2, kNan));
  ASSERT_TRUE(comparer.first());
  EXPECT_EQ(comparer.first()->step, 2);
  comparer.compare(row_at(3, kInfinity), row_at(3, 1.0));
  comparer.compare(row_at(4, 1.0), row_at(4, 1.5));
  comparer.compare(row_at(5, kNan), row_at(5, 1.0));
  EXPECT_EQ(comparer.worst()[2]->step, 2);
  EXPECT_TRUE(std::isnan(comparer.worst()[2]->abs()));
}

TEST(TrajectoryComparer, RanksInfinityAboveAnyNumber) {
  TrajectoryComparer comparer({});
  comparer.compare(row_at(1, 1.0), row_at(1, -kInfinity));
  comparer.compare(row_at(2, 1.0), row_at(2, 1e300));
  comparer.compare(row_at(3, kInfinity), row_at(3, 1.0));
  EXPECT_EQ(comparer.worst()[2]->step, 1);
  EXPECT_EQ(comparer.worst()[2]->abs(), kInfinity);
}

TEST(TrajectoryComparer, AcceptsNoOtherContactByte) {
  TrajectoryComparer comparer({.abs = 100.0});
  comparer.compare(row_at(4, 1.0, 0), row_at(4, 1.0, 1));
  ASSERT_TRUE(comparer.first());
  EXPECT_EQ(comparer.first()->field, "contact");
  EXPECT_EQ(comparer.first()->ulps, std::nullopt);
}

Contact contact_at(std::int64_t step, double overshoot_px) {
  Contact contact;
  contact.step = contact.last_step = step;
  contact.overshoot_px = overshoot_px;
  return contact;
}

TEST(TrajectoryComparer, ComparesContactsWithinTheTolerance) {
  TrajectoryComparer near({.abs = 0.1});
  near.compare(std::vector{contact_at(9, 1.0)}, std::vector{contact_at(9, 1.05)});
  EXPECT_FALSE(near.first());
  TrajectoryComparer far({.abs = 0.01});
  far.compare(std::vector{contact_at(9, 1.0)}, std::vector{contact_at(9, 1.05)});
  ASSERT_TRUE(far.first());
  EXPECT_EQ(far.first()->field, "contacts/overshoot");
  EXPECT_EQ(far.first()->step, 9);
}

TEST(TrajectoryComparer, AcceptsAnOvershootThatNeitherRunKnows) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  TrajectoryComparer both({});
  both.compare(std::vector{contact_at(9, kUnknown)}, std::vector{contact_at(9, kUnknown)});
  EXPECT_FALSE(both.first());
  TrajectoryComparer one({});
  one.compare(std::vector{contact_at(9, kUnknown)}, std::vector{contact_at(9, 1.0)});
  EXPECT_TRUE(one.first());
  std::vector lost = {contact_at(9, kUnknown)};
  lost.front().x_px = kUnknown;
  TrajectoryComparer other({});
  other.compare(lost, lost);
  EXPECT_TRUE(other.first());
}

TEST(TrajectoryComparer, ReportsMovedContactsAtAnyTolerance) {
  TrajectoryComparer comparer({.abs = 1e9});
  comparer.compare(std::vector{contact_at(9, 1.0)}, std::vector{contact_at(10, 1.0)});
  EXPECT_EQ(comparer.contacts().moved.size(), 1u);
}

}  // namespace
}  // namespace hyrax
