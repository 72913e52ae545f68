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

Row row_of_x(std::int64_t step, double x_px, std::uint8_t contact = 0) {
  return {.step = step, .t_s = 0.25 * static_cast<double>(step), .x_px = x_px, .contact = contact};
}

// After rows 1, 2 and so on, of these x.
TrajectoryComparer compared(const Tolerance& tolerance, const std::vector<std::pair<double, double>>& xs_px) {
  TrajectoryComparer comparer(tolerance);
  for (std::int64_t step = 1; const auto& [a, b] : xs_px) {
    comparer.compare(row_of_x(step, a), row_of_x(step, b));
    ++step;
  }
  return comparer;
}

TEST(TrajectoryComparer, ReportsTheFirstAndTheWorstWithinTheToleranceToo) {
  const TrajectoryComparer same = compared({}, {{1.0, 1.0}});
  EXPECT_FALSE(same.first());
  for (const auto& none : same.worst()) EXPECT_FALSE(none);
  const TrajectoryComparer exact = compared({}, {{1.0, 1.0}, {1.0, 1.5}, {1.0, 4.0}, {1.0, 2.0}});
  EXPECT_EQ(exact.first().value().step, 2);
  EXPECT_EQ(exact.first()->field, "x");
  EXPECT_EQ(exact.first()->expected, 1.0);
  EXPECT_EQ(exact.first()->actual, 1.5);
  EXPECT_EQ(exact.worst()[2].value().step, 3);
  EXPECT_EQ(exact.worst()[2]->abs(), 3.0);
  const TrajectoryComparer tolerant = compared({.abs = 1.0}, {{1.0, 1.5}});
  EXPECT_FALSE(tolerant.first());
  EXPECT_EQ(tolerant.worst()[2].value().abs(), 0.5);
}

TEST(TrajectoryComparer, RanksNanAsTheWorstAndInfinityAboveAnyNumber) {
  const TrajectoryComparer nan =
      compared({.abs = 1e9}, {{1.0, 1e6}, {kNan, kNan}, {kInfinity, 1.0}, {1.0, 1.5}, {kNan, 1.0}});
  EXPECT_EQ(nan.first().value().step, 2);
  EXPECT_EQ(nan.worst()[2]->step, 2);
  EXPECT_TRUE(std::isnan(nan.worst()[2]->abs()));
  const TrajectoryComparer infinite = compared({}, {{1.0, -kInfinity}, {1.0, 1e300}, {kInfinity, 1.0}});
  EXPECT_EQ(infinite.worst()[2]->step, 1);
  EXPECT_EQ(infinite.worst()[2]->abs(), kInfinity);
}

TEST(TrajectoryComparer, AcceptsNoOtherContactByte) {
  TrajectoryComparer comparer({.abs = 100.0});
  comparer.compare(row_of_x(4, 1.0, 0), row_of_x(4, 1.0, 1));
  EXPECT_EQ(comparer.first().value().field, "contact");
  EXPECT_EQ(comparer.first()->ulps(), std::nullopt);
}

TrajectoryComparer compared(const Tolerance& tolerance, const Contact& a, const Contact& b) {
  TrajectoryComparer comparer(tolerance);
  comparer.compare(std::vector{a}, std::vector{b});
  return comparer;
}

Contact contact_at(std::int64_t step, double overshoot_px) {
  return {.step = step, .last_step = step, .overshoot_px = overshoot_px};
}

TEST(TrajectoryComparer, ComparesContactsWithinTheTolerance) {
  EXPECT_FALSE(compared({.abs = 0.1}, contact_at(9, 1.0), contact_at(9, 1.05)).first());
  const TrajectoryComparer far = compared({.abs = 0.01}, contact_at(9, 1.0), contact_at(9, 1.05));
  EXPECT_EQ(far.first().value().field, "contacts/overshoot");
  EXPECT_EQ(far.first()->step, 9);
  // Moved ones differ at any tolerance.
  EXPECT_EQ(compared({.abs = 1e9}, contact_at(9, 1.0), contact_at(10, 1.0)).contacts().moved.size(), 1u);
}

TEST(TrajectoryComparer, AcceptsAnOvershootThatNeitherRunKnows) {
  const Contact unknown = contact_at(9, kNan);
  EXPECT_FALSE(compared({}, unknown, unknown).first());
  EXPECT_TRUE(compared({}, unknown, contact_at(9, 1.0)).first());
  Contact lost = unknown;
  lost.x_px = kNan;
  EXPECT_TRUE(compared({}, lost, lost).first());
}

}  // namespace
}  // namespace hyrax
