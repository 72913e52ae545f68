// What each action does to a body, and what it leaves unchanged.
#include "sim/scenario/apply.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

World after(const Action& action, bool is_held = false) {
  World world{.state = {1.0, 2.0, 3.0, 4.0}, .window = {800, 600}, .sprite = {64, 32}, .is_held = is_held};
  apply(action, world);
  return world;
}

void expect(const World& world, const State& state, const Size& window, const Size& sprite, bool is_held) {
  EXPECT_TRUE(same_bits(world.state, state));
  EXPECT_EQ(world.window, window);
  EXPECT_EQ(world.sprite, sprite);
  EXPECT_EQ(world.is_held, is_held);
}

constexpr Size kWindow{800, 600};
constexpr Size kSprite{64, 32};

TEST(Apply, SetsOnlyVelocityOrPosition) {
  expect(after(Fling{{-0.0, 6.0}}), {1.0, 2.0, -0.0, 6.0}, kWindow, kSprite, false);
  expect(after(Place{{5.0, 6.0}}), {5.0, 6.0, 3.0, 4.0}, kWindow, kSprite, false);
  expect(after(Stop{}), {1.0, 2.0, 0.0, 0.0}, kWindow, kSprite, false);
}

TEST(Apply, ResizesWhatIsNamed) {
  const State state{1.0, 2.0, 3.0, 4.0};
  expect(after(Resize{Size{7, 8}, {}}), state, {7, 8}, kSprite, false);
  expect(after(Resize{{}, Size{7, 8}}), state, kWindow, {7, 8}, false);
  expect(after(Resize{Size{5, 6}, Size{7, 8}}), state, {5, 6}, {7, 8}, false);
}

TEST(Apply, StopsAndHoldsAGrabbedSpriteUntilItsRelease) {
  expect(after(Grab{}), {1.0, 2.0, 0.0, 0.0}, kWindow, kSprite, true);
  expect(after(Release{{5.0, 6.0}}, true), {1.0, 2.0, 5.0, 6.0}, kWindow, kSprite, false);
  expect(after(Fling{{5.0, 6.0}}, true), {1.0, 2.0, 5.0, 6.0}, kWindow, kSprite, true);
}

TEST(Apply, LeavesTheStateUnchangedInAHitch) {
  expect(after(Hitch{0.5}), {1.0, 2.0, 3.0, 4.0}, kWindow, kSprite, false);
}

}  // namespace
}  // namespace hyrax
