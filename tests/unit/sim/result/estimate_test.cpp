#include "sim/result/estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "sim/scenario/split_mix64.h"

namespace hyrax {
namespace {

TEST(Quantile, IsBetweenItsNeighbours) {
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({1.0, 2.0}, 0.25), 1.25);
  EXPECT_EQ(quantile({7.0}, 0.95), 7.0);
}

// Of 21 values, P(median of a resample <= the 6th) is 0.018 and of the 7th 0.056.
TEST(MedianEstimate, HasItsBootstrapInterval) {
  std::vector<double> values(21);
  std::iota(values.begin(), values.end(), 1.0);
  const MedianEstimate estimate = median_of(values);
  EXPECT_EQ(estimate.median, 11.0);
  EXPECT_EQ(estimate.low, 7.0);
  EXPECT_EQ(estimate.high, 15.0);
  EXPECT_TRUE(std::isnan(median_of({}).median));
  EXPECT_EQ(median_of({4.0}).high, 4.0);
  EXPECT_EQ(median_of({4.0, 2.0}).low, 2.0);
}

// The same by drawing 20,000 resamples.
TEST(MedianEstimate, IsWhatResamplingGives) {
  for (const std::uint64_t count : {21u, 25u}) {
    std::vector<double> values, medians;
    for (std::uint64_t k = 0; k < count; ++k) values.push_back(split_mix64_unit(1, k));
    std::uint64_t draw = 0;
    for (int resample = 0; resample < 20'000; ++resample) {
      std::vector<double> drawn;
      for (std::uint64_t value = 0; value < count; ++value)
        drawn.push_back(values[split_mix64(2, draw++) % count]);
      medians.push_back(quantile(drawn, 0.5));
    }
    EXPECT_EQ(median_of(values).low, quantile(medians, 0.025)) << count;
    EXPECT_EQ(median_of(values).high, quantile(medians, 0.975)) << count;
  }
}

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

TEST(Share, CountsWhatHasTheProperty) {
  Share share;
  for (const bool has_it : {true, false, true, true}) share.add(has_it);
  EXPECT_EQ(share.count, 3);
  EXPECT_EQ(share.of, 4);
  EXPECT_EQ(share.part(), 0.75);
}

}  // namespace
}  // namespace hyrax
