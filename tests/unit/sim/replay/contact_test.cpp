// Which steps make a contact, and what is recorded of its first one.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

constexpr double kRestitution = 0.6;
constexpr double kFriction = 0.8;
constexpr double kDrag = 0.999;

struct Throw {
  Position start;
  Velocity velocity;
  std::int64_t steps = 1;
  std::vector<Event> events = {};
};

struct Played {
  explicit Played(const Throw& thrown, double dt_s = 1.0 / 60.0) {
    Scenario scenario = fling_at(60.0, thrown.steps, thrown.events);
    scenario.start = thrown.start;
    scenario.start_velocity = thrown.velocity;
    scenario.clock.base = FixedStep{dt_s};
    summary = replay(shipped_core(), scenario, trace);
  }
  const std::vector<Contact>& contacts() const { return trace.contacts(); }
  TraceSink trace;
  RunSummary summary;
};

// Where the floor and the right wall stop the sprite's corner.
constexpr double kRight_px = 1920.0 - 128.0;
constexpr double kFloor_px = 1080.0 - 128.0;

TEST(Contact, HoldsTheStepAsItMetTheWall) {
  const Played played(Throw{{5.0, 500.0}, {-900.0, 0.0}});
  const double vx_px_per_s = -900.0 * kDrag;
  ASSERT_EQ(played.contacts().size(), 1u);
  const Contact& contact = played.contacts()[0];
  EXPECT_EQ(contact.wall, Wall::left);
  EXPECT_EQ(contact.step, 1);
  EXPECT_EQ(contact.last_step, 1);
  EXPECT_EQ(contact.t_s, 1.0 / 60.0);
  EXPECT_EQ(contact.x_px, 0.0);
  EXPECT_EQ(contact.y_px, played.trace.rows()[1].y_px);
  EXPECT_EQ(contact.vx_before_px_per_s, vx_px_per_s);
  EXPECT_EQ(contact.vx_after_px_per_s, -vx_px_per_s * kRestitution);
  EXPECT_EQ(contact.vy_before_px_per_s, 1200.0 * (1.0 / 60.0) * kDrag);
  EXPECT_EQ(contact.vy_after_px_per_s, contact.vy_before_px_per_s);
  EXPECT_EQ(contact.overshoot_px, -(5.0 + vx_px_per_s * (1.0 / 60.0)));
}

TEST(Contact, InACornerIsTwoAndXComesBeforeY) {
  const Played played(Throw{{kRight_px - 5.0, kFloor_px - 5.0}, {900.0, 700.0}});
  ASSERT_EQ(played.contacts().size(), 2u);
  const Contact& wall = played.contacts()[0];
  const Contact& ground = played.contacts()[1];
  EXPECT_EQ(wall.wall, Wall::right);
  EXPECT_EQ(ground.wall, Wall::ground);
  EXPECT_EQ(played.trace.rows()[1].contact, 10);
  // The wall turns vx alone; the ground meets what the wall left.
  EXPECT_EQ(wall.vx_after_px_per_s, -(900.0 * kDrag) * kRestitution);
  EXPECT_EQ(wall.vy_after_px_per_s, wall.vy_before_px_per_s);
  EXPECT_EQ(ground.vx_before_px_per_s, wall.vx_after_px_per_s);
  EXPECT_EQ(ground.vy_before_px_per_s, wall.vy_after_px_per_s);
  EXPECT_EQ(ground.vx_after_px_per_s, ground.vx_before_px_per_s * kFriction);
  EXPECT_EQ(ground.vy_after_px_per_s, -ground.vy_before_px_per_s * kRestitution);
  for (const Contact& contact : played.contacts()) {
    EXPECT_EQ(contact.x_px, kRight_px);
    EXPECT_EQ(contact.y_px, kFloor_px);
    EXPECT_GT(contact.overshoot_px, 0.0);
  }
}

TEST(Contact, InEachOtherCornerIsTwoAsWell) {
  const auto walls = [](const Throw& thrown) {
    std::vector<Wall> met;
    const Played played(thrown);
    for (const Contact& contact : played.contacts()) met.push_back(contact.wall);
    return met;
  };
  EXPECT_EQ(walls({{5.0, 5.0}, {-900.0, -700.0}}), (std::vector<Wall>{Wall::left, Wall::top}));
  EXPECT_EQ(walls({{kRight_px - 5.0, 5.0}, {900.0, -700.0}}), (std::vector<Wall>{Wall::right, Wall::top}));
  EXPECT_EQ(walls({{5.0, kFloor_px - 5.0}, {-900.0, 700.0}}), (std::vector<Wall>{Wall::left, Wall::ground}));
}

TEST(Contact, DoesNotBeginOnTheBoundItself) {
  // At dt 0 nothing moves: the sprite is on both bounds and touches neither.
  EXPECT_TRUE(Played(Throw{{kRight_px, kFloor_px}, {900.0, 700.0}}, 0.0).contacts().empty());
  EXPECT_TRUE(Played(Throw{{0.0, 0.0}, {-900.0, -700.0}}, 0.0).contacts().empty());
}

TEST(Contact, OfRestIsOneThatDoesNotEnd) {
  const Played played(Throw{{500.0, kFloor_px}, {0.0, 0.0}, 100}, 1.0 / 240.0);
  ASSERT_EQ(played.contacts().size(), 1u);
  EXPECT_EQ(played.contacts()[0].step, 1);
  EXPECT_EQ(played.contacts()[0].last_step, 100);
  EXPECT_EQ(played.summary.contacts.ground, 1);
  EXPECT_EQ(played.summary.clamped_steps.ground, 100);
  EXPECT_EQ(played.summary.rest_steps, 100);
  EXPECT_EQ(played.trace.rows()[50].contact, 24);
  // Recorded at its first step, in which the speed of one frame's fall was zeroed.
  EXPECT_EQ(played.contacts()[0].vy_before_px_per_s, 1200.0 * (1.0 / 240.0) * kDrag);
  EXPECT_EQ(played.contacts()[0].vy_after_px_per_s, 0.0);
}

TEST(Contact, IsTwoWhereOneStepIsFree) {
  const Played played(Throw{{500.0, kFloor_px}, {}, 9, {{std::int64_t{4}, Fling{{0.0, -5.5}}}}}, 1.0 / 240.0);
  ASSERT_EQ(played.contacts().size(), 2u);
  EXPECT_EQ(played.contacts()[0].last_step, 4);
  EXPECT_GT(played.contacts()[1].step, 5);
}

TEST(Contact, EndsWhereTheSpriteIsGrabbed) {
  const Played played(
      Throw{{500.0, kFloor_px}, {}, 20, {{std::int64_t{5}, Grab{}}, {std::int64_t{8}, Release{}}}},
      1.0 / 240.0);
  ASSERT_EQ(played.contacts().size(), 2u);
  EXPECT_EQ(played.contacts()[0].last_step, 5);
  EXPECT_EQ(played.contacts()[1].step, 9);
  EXPECT_EQ(played.contacts()[1].last_step, 20);
}

TEST(Contact, ContinuesWhileAnotherWallIsHit) {
  // Along the floor into the right wall.
  const Played played(Throw{{kRight_px - 30.0, kFloor_px}, {2500.0, 0.0}, 10}, 1.0 / 240.0);
  ASSERT_EQ(played.contacts().size(), 2u);
  EXPECT_EQ(played.contacts()[0].wall, Wall::ground);
  EXPECT_EQ(played.contacts()[0].last_step, 10);
  EXPECT_EQ(played.contacts()[1].wall, Wall::right);
  EXPECT_GT(played.contacts()[1].step, 1);
  // The wall met first, so its "before" is that of the flight, and friction acts after it.
  const Row& row = played.trace.rows()[static_cast<std::size_t>(played.contacts()[1].step)];
  EXPECT_EQ(row.vx_px_per_s, played.contacts()[1].vx_after_px_per_s * kFriction);
}

TEST(Contact, OfAnotherWallInTheNextStepIsAnother) {
  Scenario scenario = fling_at(60.0, 6);
  scenario.window = {100, 1080};  // Narrower than the sprite: left and right in turn.
  TraceSink trace;
  replay(shipped_core(), scenario, trace);
  ASSERT_EQ(trace.contacts().size(), 6u);
  for (const Contact& contact : trace.contacts()) EXPECT_EQ(contact.last_step, contact.step);
  EXPECT_EQ(trace.contacts()[0].wall, Wall::right);
  EXPECT_EQ(trace.contacts()[1].wall, Wall::left);
}

TEST(Contact, AtTheFirstStepReportsTheOvershootOfAStartFarOutside) {
  const Played played(Throw{{1e12, -1e12}, {}});
  ASSERT_EQ(played.contacts().size(), 2u);
  EXPECT_EQ(played.contacts()[0].overshoot_px, 1e12 - kRight_px);
  EXPECT_EQ(played.contacts()[1].wall, Wall::top);
  EXPECT_LE(played.contacts()[1].overshoot_px, 1e12);
}

}  // namespace
}  // namespace hyrax
