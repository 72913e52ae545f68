// The fingerprint of a core: the same for the same bits, another for any other core.
#include "sim/replay/fingerprint.h"

#include <gtest/gtest.h>

#include "sim/replay/core_constants.h"
#include "sim/replay/listing_kernel.h"

namespace hyrax {
namespace {

TEST(Fingerprint, IsTheSameForTheSameBits) {
  EXPECT_EQ(core_fingerprint(listing_kernel(core_constants()).get()), core_fingerprint());
}

TEST(Fingerprint, DependsOnEveryConstant) {
  for (double Constants::*constant :
       {&Constants::gravity_px_per_s2, &Constants::restitution, &Constants::air_drag,
        &Constants::ground_friction, &Constants::rest_threshold_px_per_s}) {
    Constants changed = core_constants();
    // A threshold decides; the others are factors of every step.
    changed.*constant *= constant == &Constants::rest_threshold_px_per_s ? 1.1 : 1.0 + 0x1p-50;
    EXPECT_NE(core_fingerprint(listing_kernel(changed).get()), core_fingerprint());
  }
}

}  // namespace
}  // namespace hyrax
