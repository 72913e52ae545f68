// How far two runs are apart: rows, in energy too, and what is still rounding; numbers, in units in the last
// place; contacts that moved, vanished or appeared.
#include "sim/compare/run_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/compare/comparison.h"

namespace hyrax {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

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

Row row_with(double Row::*field, double value) {
  Row row = kRow;
  row.*field = value;
  return row;
}

TEST(RunDistance, AWallOfAnotherSourceInBothRunsSetsNoClass) {
  Row other = kRow;
  for (const int contact : {0, 8 | kRestBit, 1}) {
    other.contact = static_cast<std::uint8_t>(contact);
    RunDistance distance(static_cast<int>(Wall::ground));
    distance.add(kRow, other);
    EXPECT_EQ(distance.has_other_walls(), contact == 1);
    EXPECT_EQ(distance.is_rounding(), contact != 1);
    EXPECT_FALSE(distance_of(kRow, other).is_rounding());
  }
}

TEST(RunDistance, RoundingHasALimitForEveryQuantity) {
  const struct {
    double Row::*field;
    double limit;
  } limits[] = {{&Row::t_s, 1e-9},  {&Row::dt_s, 1e-9},        {&Row::x_px, 1e-6},
                {&Row::y_px, 1e-6}, {&Row::vx_px_per_s, 1e-6}, {&Row::vy_px_per_s, 1e-6}};
  for (const auto& [field, limit] : limits)
    for (const double part : {0.99, -0.99, 1.01, -1.01})
      EXPECT_EQ(distance_of(kRow, row_with(field, kRow.*field + part * limit)).is_rounding(),
                std::fabs(part) < 1.0);
}

// A fast one may differ by more, an infinity is within rounding of itself only, and a NaN of nothing.
TEST(RunDistance, RoundingOfAVelocityGrowsWithIt) {
  const struct {
    double a, b;
    bool is_rounding;
  } cases[] = {{-1e9, -1e9 - 0.9e-3, true}, {-1e9, -1e9 - 1.1e-3, false}, {HUGE_VAL, HUGE_VAL, true},
               {HUGE_VAL, 0.0, false},      {kNotANumber, 0.0, false},    {kNotANumber, kNotANumber, false}};
  for (const auto& [a, b, is_rounding] : cases)
    EXPECT_EQ(distance_of(row_with(&Row::vx_px_per_s, a), row_with(&Row::vx_px_per_s, b)).is_rounding(),
              is_rounding)
        << a << ", " << b;
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
  EXPECT_EQ(distance.largest().value().px, 5.0);
  EXPECT_EQ(distance.largest()->step, kRow.step + 5);
}

TEST(RunDistance, ANanIsInfinitelyFar) {
  const Row other = row_with(&Row::x_px, kNotANumber);
  const RunDistance distance = distance_of(kRow, other);
  EXPECT_EQ(distance.largest().value().px, HUGE_VAL);
  EXPECT_FALSE(distance.is_rounding());
  EXPECT_FALSE(distance_of(other, other).is_rounding());
}

TEST(RunDistance, AContactsQuantitiesHaveTheSameLimits) {
  for (const ContactColumn& quantity : kContactQuantities) {
    const double limit = quantity.unit == std::string_view("s") ? 1e-9 : 1e-6;
    const Contact contact{.step = 3};
    Contact other = contact;
    double& value = other.*std::get<double Contact::*>(quantity.get);
    RunDistance distance;
    value = 0.99 * limit;
    distance.add(contact, other);
    EXPECT_TRUE(distance.is_rounding()) << quantity.name;
    value = 1.01 * limit;
    distance.add(contact, other);
    EXPECT_FALSE(distance.is_rounding()) << quantity.name;
  }
}

constexpr double kGravity = 1200.0;

TEST(EnergyDifference, DoesNotLoseSmallDifferencesOfLargeSpeeds) {
  EnergyDifference energy(kGravity);
  energy.add({.vx_px_per_s = 1e9}, {.vx_px_per_s = 1e9 + 0.25});
  EXPECT_DOUBLE_EQ(energy.largest()->px2_per_s2, 0.25 * 1e9 + 0.5 * 0.0625);
}

Contact at(Wall wall, std::int64_t step, std::int64_t last_step = -1) {
  Contact contact;
  contact.wall = wall;
  contact.step = step;
  contact.last_step = last_step < 0 ? step : last_step;
  return contact;
}

const std::vector<Contact> kBounces = {at(Wall::right, 110), at(Wall::ground, 134), at(Wall::ground, 212),
                                       at(Wall::ground, 257, 600)};

TEST(ContactChanges, OfAListThatIsFullEndWithIt) {
  std::vector<Contact> full(kContactsRecordedMax, at(Wall::ground, 1));
  for (std::int64_t step = 1; Contact & contact : full) contact.step = contact.last_step = step++;
  std::vector<Contact> other(full.begin() + 1, full.end());  // Its last one is later than the full list.
  other.back().step = other.back().last_step = kContactsRecordedMax + 1;
  const ContactChanges changes = contact_changes(other, full);
  EXPECT_TRUE(changes.is_cut);
  EXPECT_TRUE(changes.only_a.empty());
  EXPECT_EQ(changes.total(), 2);
  EXPECT_FALSE(contact_changes(other, other).is_cut);
  EXPECT_TRUE(contact_changes(full, full).is_none());
}

std::string text_of(const Contact& contact) {
  return std::string(name_of(contact.wall)) + " " + std::to_string(contact.step) + ".." +
         std::to_string(contact.last_step);
}

// Such as "moved ground 212..212 to 213..213".
std::vector<std::string> told(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  const ContactChanges changes = contact_changes(a, b);
  std::vector<std::string> texts;
  for (const ContactChanges::Moved& moved : changes.moved)
    texts.push_back("moved " + text_of(moved.from) + " to " + text_of(moved.to));
  for (const Contact& contact : changes.only_a) texts.push_back("gone " + text_of(contact));
  for (const Contact& contact : changes.only_b) texts.push_back("new " + text_of(contact));
  return texts;
}

TEST(ContactChanges, AreMovesAndWhatVanishedAndAppeared) {
  using Texts = std::vector<std::string>;
  const Contact right = at(Wall::right, 110), first = at(Wall::ground, 134), second = at(Wall::ground, 212);
  EXPECT_EQ(told({right, second}, {right, at(Wall::ground, 213)}),
            Texts{"moved ground 212..212 to ground 213..213"});
  EXPECT_EQ(told({at(Wall::ground, 257, 600)}, {at(Wall::ground, 257, 599)}),
            Texts{"moved ground 257..600 to ground 257..599"});
  EXPECT_EQ(told(kBounces, {kBounces[0], kBounces[2], kBounces[3]}), Texts{"gone ground 134..134"});
  EXPECT_EQ(told({right, first}, {at(Wall::top, 20), right, first}), Texts{"new top 20..20"});
  // Another wall is no move, and a corner has two contacts.
  EXPECT_EQ(told({right}, {at(Wall::left, 110)}), (Texts{"gone right 110..110", "new left 110..110"}));
  EXPECT_EQ(told({right, at(Wall::ground, 110)}, {right}), Texts{"gone ground 110..110"});
  // Moves are paired in order.
  EXPECT_EQ(told({first, second, at(Wall::ground, 257)}, {at(Wall::ground, 135), second}),
            (Texts{"moved ground 134..134 to ground 135..135", "gone ground 257..257"}));
}

TEST(Ulps, AreCountedFromEndToEndAcrossPowersOfTwoAndZero) {
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  const struct {
    double a, b;
    std::optional<std::uint64_t> ulps;
  } cases[] = {{1.0, 1.0, 0},
               {HUGE_VAL, HUGE_VAL, 0},
               {0.0, -0.0, 0},
               {std::nextafter(2.0, 0.0), std::nextafter(2.0, 3.0), 2},
               {-kSmallest, kSmallest, 2},
               {-0.0, kSmallest, 1},
               {1.0, 2.0, std::uint64_t{1} << 52},
               {-HUGE_VAL, HUGE_VAL, 2 * std::uint64_t{0x7FF0000000000000}},
               {std::numeric_limits<double>::max(), HUGE_VAL, 1},
               {std::nan(""), 1.0, std::nullopt},
               {std::nan(""), std::nan(""), std::nullopt}};
  for (const auto& [a, b, ulps] : cases) {
    EXPECT_EQ(ulps_between(a, b), ulps) << a << ", " << b;
    EXPECT_EQ(ulps_between(b, a), ulps) << a << ", " << b;
  }
  for (const double value : {1.0, 0.6, -1200.0, 4.9e-322, 1e-308, 952.0}) {
    EXPECT_EQ(ulps_between(value, std::nextafter(value, HUGE_VAL)), 1u) << value;
    EXPECT_EQ(ulps_between(std::nextafter(value, -HUGE_VAL), value), 1u) << value;
  }
}

}  // namespace
}  // namespace hyrax
