// The listing's step with its order free: the core in the paper's order, and not in any other.
#include <gtest/gtest.h>

#include "sim/core/core.h"
#include "sim/core/shipped_core.h"
#include "sim/motion/step.h"
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

// How many of the 300 frames of a throw across a desktop differ from the core with this order.
int frames_unlike_core(StepOrder order) {
  constexpr Bounds kBounds{1792, 952};
  State core{300.0, 500.0, 2400.0, -700.0};
  State other = core;
  int unlike = 0;
  for (int frame = 0; frame < 300; ++frame) {
    core = shipped_core().step(core, 1.0 / 60.0, kBounds);
    other = stepped(*shipped_core().constants, order, other, 1.0 / 60.0, kBounds);
    unlike += same_bits(core, other) ? 0 : 1;
  }
  return unlike;
}

TEST(ListingStep, IsTheCoreInThePapersOrder) {
  EXPECT_EQ(frames_unlike_core(StepOrder::paper), 0);
  EXPECT_EQ(steps_that_differ_from_listing(shipped_core(), 100'000), 0);
}

TEST(ListingStep, IsAnotherInAnother) {
  for (const StepOrder order : {StepOrder::drag_first, StepOrder::position_first, StepOrder::walls_first})
    EXPECT_GT(frames_unlike_core(order), 0);
}

TEST(ListingStep, UsesTheGivenConstants) {
  Constants elastic = *shipped_core().constants;
  elastic.air_drag = 1.0;
  elastic.restitution = 1.0;
  const State after = stepped(elastic, StepOrder::paper, {10.0, 100.0, -900.0, 0.0}, 1.0 / 60.0, {1792, 952});
  EXPECT_EQ(after.vx_px_per_s, 900.0);
  EXPECT_EQ(after.vy_px_per_s, elastic.gravity_px_per_s2 * (1.0 / 60.0));
}

}  // namespace
}  // namespace hyrax
