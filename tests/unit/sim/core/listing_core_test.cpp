// The listing's step as a core: with the shipped constants the shipped bits.
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include "sim/core/core.h"
#include "sim/replay/replay.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

Digest hash_of(const Scenario& scenario, const Core& core) { return replay(core, scenario).state_hash; }

TEST(ListingCore, WithTheShippedConstantsGivesTheShippedBits) {
  const Core core = listing_core(*shipped_core().constants);
  for (const Scenario& scenario : {eventful_fling(), fling_at(60.0, 20'000), fling_at(240.0, 20'000)})
    EXPECT_EQ(hash_of(scenario, core), hash_of(scenario, shipped_core()));
}

TEST(ListingCore, EveryConstantMatters) {
  const Digest shipped = hash_of(eventful_fling(), shipped_core());
  for (double Constants::*constant :
       {&Constants::gravity_px_per_s2, &Constants::restitution, &Constants::air_drag,
        &Constants::ground_friction, &Constants::rest_threshold_px_per_s}) {
    Constants changed = *shipped_core().constants;
    changed.*constant *= constant == &Constants::rest_threshold_px_per_s ? 10.0 : 1.0001;
    EXPECT_NE(hash_of(fling_at(60.0, 600), listing_core(changed)),
              hash_of(fling_at(60.0, 600), shipped_core()));
    EXPECT_EQ(listing_core(changed).constants.value().*constant, changed.*constant);
  }
  EXPECT_EQ(hash_of(eventful_fling(), listing_core(*shipped_core().constants)), shipped);
}

}  // namespace
}  // namespace hyrax
