// A traced step with another constant is the step of a header with that constant.
#include "sim/cause/header_change.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include "sim/core/listing_core.h"
#include "sim/core/traced_core.h"
#include "sim/replay/replay.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

TracedStep shipped_step() { return read_step(shipped_core().record.step).value(); }

Digest hash_of(const Core& core) { return replay(core, eventful_fling()).state_hash; }

TEST(WithConstants, PlaysAsTheListingWithThatConstant) {
  for (const double gravity : {1250.0, -1200.0, 0.0, -0.0}) {
    Constants constants = shipped_core().constants.value();
    constants.gravity_px_per_s2 = gravity;
    const std::optional<Core> core = traced_core(with_constants(shipped_step(), {{1200.0, gravity}}));
    ASSERT_TRUE(core);
    EXPECT_EQ(hash_of(*core), hash_of(listing_core(constants))) << gravity;
  }
}

TEST(WithConstants, IsCanonicalAndGoesBack) {
  const TracedStep step = shipped_step();
  for (const double gravity : {1250.0, -1200.0}) {
    const TracedStep changed = with_constants(step, {{1200.0, gravity}});
    EXPECT_NE(changed, step);
    EXPECT_EQ(read_step(step_text(changed)), changed);
    EXPECT_EQ(with_constants(changed, {{gravity, 1200.0}}), step);
  }
  EXPECT_EQ(with_constants(step, {{1201.0, 1250.0}}), step);
  const TracedStep swapped = with_constants(step, {{0.6, 0.8}, {0.8, 0.6}});
  EXPECT_NE(swapped, step);
  EXPECT_EQ(with_constants(swapped, {{0.6, 0.8}, {0.8, 0.6}}), step);
}

}  // namespace
}  // namespace hyrax
