#include "sim/result/interval.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

TEST(Band, IsTheMedianAndTheMiddleEightOfTen) {
  const auto band = band_of({10.0, 0.0, 2.0, 4.0, 6.0, 8.0, 1.0, 3.0, 5.0, 7.0, 9.0});
  ASSERT_TRUE(band);
  EXPECT_EQ(band->samples, 11);
  EXPECT_DOUBLE_EQ(band->median, 5.0);
  EXPECT_DOUBLE_EQ(band->low, 1.0);
  EXPECT_DOUBLE_EQ(band->high, 9.0);
  EXPECT_FALSE(band_of({}));
}

// 13 of 100: Wilson's interval is 0.0776 .. 0.2098 (both are roots of (p - s)^2 = z^2 s (1 - s) / n).
TEST(Share, HasWilsonsInterval) {
  const Share share{13, 100};
  EXPECT_NEAR(share.low(), 0.0776, 5e-5);
  EXPECT_NEAR(share.high(), 0.2098, 5e-5);
}

TEST(Share, NeverLeavesZeroToOne) {
  EXPECT_EQ((Share{0, 50}.low()), 0.0);
  EXPECT_GT((Share{0, 50}.high()), 0.0);
  EXPECT_EQ((Share{50, 50}.high()), 1.0);
  EXPECT_LT((Share{50, 50}.low()), 1.0);
  EXPECT_EQ((Share{0, 0}.low()), 0.0);
  EXPECT_EQ((Share{0, 0}.high()), 1.0);
}

}  // namespace
}  // namespace hyrax
