// A traced step with another constant is the step of a header with that constant.
#include "sim/cause/constant_change.h"

#include <gtest/gtest.h>

#include "sim/replay/replay.h"
#include "sim/replay/traced_kernel.h"
#include "sim/trace/core_record.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/cause/hand_step.h"

namespace hyrax {
namespace {

TracedStep shipped_step() { return read_step(core_record().step).value(); }

Digest hash_of(const Kernel& kernel) { return replay(eventful_fling(), {}, {.kernel = &kernel}).state_hash; }

TEST(WithConstant, PlaysAsTheListingWithThatConstant) {
  for (const double gravity : {1250.0, -1200.0, 0.0, -0.0}) {
    HandStep step;
    step.constants.gravity_px_per_s2 = gravity;
    const auto kernel = make_traced_kernel(with_constant(shipped_step(), 1200.0, gravity));
    ASSERT_NE(kernel, nullptr);
    EXPECT_EQ(hash_of(*kernel), hash_of(KernelOf<HandCores>(HandCores{&step}))) << gravity;
  }
}

TEST(WithConstant, IsCanonicalAndGoesBack) {
  const TracedStep step = shipped_step();
  for (const double gravity : {1250.0, -1200.0}) {
    const TracedStep changed = with_constant(step, 1200.0, gravity);
    EXPECT_NE(changed, step);
    EXPECT_EQ(read_step(step_text(changed)), changed);
    EXPECT_EQ(with_constant(changed, gravity, 1200.0), step);
  }
  EXPECT_EQ(with_constant(step, 1201.0, 1250.0), step);
}

}  // namespace
}  // namespace hyrax
