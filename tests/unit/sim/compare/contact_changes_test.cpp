// How the contacts of two runs differ: moved, vanished, appeared.
#include <gtest/gtest.h>

#include "sim/compare/comparison.h"

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

TEST(ContactChanges, AreNoneBetweenEqualLists) {
  EXPECT_TRUE(contact_changes({}, {}).is_none());
  EXPECT_TRUE(contact_changes(kBounces, kBounces).is_none());
}

TEST(ContactChanges, IgnoreQuantitiesOtherThanWallAndSteps) {
  std::vector<Contact> other = kBounces;
  other[1].vy_after_px_per_s = 1.0;
  other[2].t_s = 5.0;
  EXPECT_TRUE(contact_changes(kBounces, other).is_none());
}

TEST(ContactChanges, OfAListThatIsFullEndWithIt) {
  std::vector<Contact> full, sparse;
  for (std::int64_t step = 1; step <= kContactsRecordedMax; ++step) full.push_back(at(Wall::ground, step));
  for (std::int64_t step = 2; step <= 2 * kContactsRecordedMax; step += 4)
    sparse.push_back(at(Wall::ground, step));
  const ContactChanges changes = contact_changes(sparse, full);
  EXPECT_TRUE(changes.is_cut);
  EXPECT_TRUE(changes.only_a.empty());
  EXPECT_EQ(changes.total(), kContactsRecordedMax / 4 * 3);
  EXPECT_FALSE(contact_changes(sparse, sparse).is_cut);
  EXPECT_TRUE(contact_changes(full, full).is_none());
}

TEST(ContactChanges, ReportAMovedContact) {
  std::vector<Contact> other = kBounces;
  other[2] = at(Wall::ground, 213);
  const ContactChanges changes = contact_changes(kBounces, other);
  ASSERT_EQ(changes.moved.size(), 1u);
  EXPECT_EQ(changes.moved[0].from.step, 212);
  EXPECT_EQ(changes.moved[0].to.step, 213);
  EXPECT_TRUE(changes.only_a.empty());
  EXPECT_TRUE(changes.only_b.empty());
}

TEST(ContactChanges, ReportAContactThatLastsLonger) {
  std::vector<Contact> other = kBounces;
  other[3].last_step = 599;
  const ContactChanges changes = contact_changes(kBounces, other);
  ASSERT_EQ(changes.moved.size(), 1u);
  EXPECT_EQ(changes.moved[0].from.last_step, 600);
  EXPECT_EQ(changes.moved[0].to.last_step, 599);
}

TEST(ContactChanges, ReportAVanishedContact) {
  std::vector<Contact> other = kBounces;
  other.erase(other.begin() + 1);
  const ContactChanges changes = contact_changes(kBounces, other);
  ASSERT_EQ(changes.only_a.size(), 1u);
  EXPECT_EQ(changes.only_a[0].step, 134);
  EXPECT_TRUE(changes.only_b.empty());
  EXPECT_TRUE(changes.moved.empty());
}

TEST(ContactChanges, ReportAnAppearedContact) {
  std::vector<Contact> other = kBounces;
  other.insert(other.begin(), at(Wall::top, 20));
  const ContactChanges changes = contact_changes(kBounces, other);
  ASSERT_EQ(changes.only_b.size(), 1u);
  EXPECT_EQ(changes.only_b[0].wall, Wall::top);
  EXPECT_TRUE(changes.only_a.empty());
}

TEST(ContactChanges, DoNotReportAnotherWallAsAMove) {
  std::vector<Contact> other = kBounces;
  other[0] = at(Wall::left, 110);
  const ContactChanges changes = contact_changes(kBounces, other);
  EXPECT_TRUE(changes.moved.empty());
  ASSERT_EQ(changes.only_a.size(), 1u);
  ASSERT_EQ(changes.only_b.size(), 1u);
  EXPECT_EQ(changes.only_a[0].wall, Wall::right);
  EXPECT_EQ(changes.only_b[0].wall, Wall::left);
}

TEST(ContactChanges, DistinguishTheTwoContactsOfACorner) {
  const std::vector<Contact> corner = {at(Wall::right, 50), at(Wall::ground, 50)};
  const std::vector<Contact> wall_only = {at(Wall::right, 50)};
  const ContactChanges changes = contact_changes(corner, wall_only);
  ASSERT_EQ(changes.only_a.size(), 1u);
  EXPECT_EQ(changes.only_a[0].wall, Wall::ground);
  EXPECT_TRUE(contact_changes(corner, corner).is_none());
}

TEST(ContactChanges, PairMovesInOrderAndLeaveTheRest) {
  const std::vector<Contact> before = {at(Wall::ground, 10), at(Wall::ground, 20), at(Wall::ground, 30)};
  const std::vector<Contact> after = {at(Wall::ground, 11), at(Wall::ground, 20)};
  const ContactChanges changes = contact_changes(before, after);
  ASSERT_EQ(changes.moved.size(), 1u);
  EXPECT_EQ(changes.moved[0].from.step, 10);
  EXPECT_EQ(changes.moved[0].to.step, 11);
  ASSERT_EQ(changes.only_a.size(), 1u);
  EXPECT_EQ(changes.only_a[0].step, 30);
}

TEST(ContactChanges, ToAnEmptyListAreAllContacts) {
  EXPECT_EQ(contact_changes(kBounces, {}).only_a.size(), kBounces.size());
  EXPECT_EQ(contact_changes({}, kBounces).only_b.size(), kBounces.size());
}

}  // namespace
}  // namespace hyrax
