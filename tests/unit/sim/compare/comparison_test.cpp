// How the contacts of two runs differ: moved, vanished, appeared; and numbers, in units in the last place.
#include "sim/compare/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hyrax {
namespace {

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
