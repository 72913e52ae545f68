// A claim's verdict follows from its number.
#include <gtest/gtest.h>

#include "sim/study/paper_claim.h"

namespace hyrax {
namespace {

TEST(ClaimOnSpeed, HoldsOfAFastStepAlone) {
  EXPECT_EQ(claims_on_speed(1e-8).front().verdict, ClaimVerdict::holds);
  EXPECT_EQ(claims_on_speed(1e-4).front().verdict, ClaimVerdict::does_not_hold);
}

}  // namespace
}  // namespace hyrax
