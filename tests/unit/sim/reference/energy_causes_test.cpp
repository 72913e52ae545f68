#include "sim/reference/energy_causes.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

ArcErrors arc_with(double gravity_px2_per_s2, double drag_px2_per_s2) {
  ArcErrors arc;
  arc.energy_parts = {.gravity = gravity_px2_per_s2, .drag = drag_px2_per_s2};
  return arc;
}

ImpactErrors contact_at(std::int64_t step, Wall wall, double lift_px2_per_s2) {
  ImpactErrors contact;
  contact.step = step;
  contact.wall = wall;
  contact.energy_parts = {.lift = lift_px2_per_s2};
  contact.late_bounce_px2_per_s2 = 600.0;
  return contact;
}

TEST(EnergyCauseSum, IsTheHeightThatEachEnergyLiftsBy) {
  EnergyCauseSum causes(1200.0);
  causes.add(arc_with(1.1, -12.3));
  causes.add(arc_with(2.2, -12.3));
  causes.add(contact_at(7, Wall::ground, 120.0));
  EXPECT_DOUBLE_EQ(causes.now().gravity, 3.3 / 1200.0);
  EXPECT_DOUBLE_EQ(causes.now().drag, -0.0205);
  EXPECT_DOUBLE_EQ(causes.now().lift, 0.1);
  EXPECT_DOUBLE_EQ(causes.now().bounce, 0.5);
  EXPECT_DOUBLE_EQ(causes.now().sum(), 0.00275 - 0.0205 + 0.1 + 0.5);
}

TEST(EnergyCauseSum, CountsTheLiftOutOfACornerOnce) {
  EnergyCauseSum causes(1200.0);
  causes.add(contact_at(7, Wall::left, 120.0));
  causes.add(contact_at(7, Wall::ground, 120.0));
  EXPECT_DOUBLE_EQ(causes.now().lift, 0.1);
  EXPECT_DOUBLE_EQ(causes.now().bounce, 1.0);
  causes.add(contact_at(8, Wall::ground, 120.0));
  EXPECT_DOUBLE_EQ(causes.now().lift, 0.2);
}

TEST(EnergyCauseSum, CountsNoBounceThatHasNoTimeOfImpact) {
  EnergyCauseSum causes(1200.0);
  ImpactErrors contact = contact_at(7, Wall::ground, 120.0);
  contact.late_bounce_px2_per_s2.reset();
  causes.add(contact);
  EXPECT_EQ(causes.now().bounce, 0.0);
}

}  // namespace
}  // namespace hyrax
