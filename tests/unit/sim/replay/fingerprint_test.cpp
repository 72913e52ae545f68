// The fingerprint of a core: the same for the same bits, another for any other core.
#include "sim/replay/fingerprint.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include "sim/core/core.h"
#include "sim/core/listing_core.h"

namespace hyrax {
namespace {

TEST(Fingerprint, IsTheSameForTheSameBits) {
  EXPECT_EQ(fingerprint_of(listing_core(*shipped_core().constants)), fingerprint_of(shipped_core()));
}

TEST(Fingerprint, DependsOnEveryConstant) {
  for (double Constants::*constant :
       {&Constants::gravity_px_per_s2, &Constants::restitution, &Constants::air_drag,
        &Constants::ground_friction, &Constants::rest_threshold_px_per_s}) {
    Constants changed = *shipped_core().constants;
    // A threshold decides; the others are factors of every step.
    changed.*constant *= constant == &Constants::rest_threshold_px_per_s ? 1.1 : 1.0 + 0x1p-50;
    EXPECT_NE(fingerprint_of(listing_core(changed)), fingerprint_of(shipped_core()));
  }
}

}  // namespace
}  // namespace hyrax
