// The listing's step as a core: with the shipped constants the shipped bits.
#include "sim/replay/listing_kernel.h"

#include <gtest/gtest.h>

#include "sim/replay/core_constants.h"
#include "sim/replay/replay.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

Digest hash_of(const Scenario& scenario, const Kernel* kernel) {
  return replay(scenario, {}, {.kernel = kernel}).state_hash;
}

TEST(ListingKernel, WithTheShippedConstantsGivesTheShippedBits) {
  const auto kernel = listing_kernel(core_constants());
  for (const Scenario& scenario : {eventful_fling(), fling_at(60.0, 20'000), fling_at(240.0, 20'000)})
    EXPECT_EQ(hash_of(scenario, kernel.get()), hash_of(scenario, nullptr));
}

TEST(ListingKernel, EveryConstantMatters) {
  const Digest shipped = hash_of(eventful_fling(), nullptr);
  for (double Constants::*constant :
       {&Constants::gravity_px_per_s2, &Constants::restitution, &Constants::air_drag,
        &Constants::ground_friction, &Constants::rest_threshold_px_per_s}) {
    Constants changed = core_constants();
    changed.*constant *= constant == &Constants::rest_threshold_px_per_s ? 10.0 : 1.0001;
    EXPECT_NE(hash_of(fling_at(60.0, 600), listing_kernel(changed).get()),
              hash_of(fling_at(60.0, 600), nullptr));
    EXPECT_EQ(listing_kernel(changed)->constants().value().*constant, changed.*constant);
  }
  EXPECT_EQ(hash_of(eventful_fling(), listing_kernel(core_constants()).get()), shipped);
}

}  // namespace
}  // namespace hyrax
