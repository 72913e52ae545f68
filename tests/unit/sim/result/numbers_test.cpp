#include "sim/result/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "sim/result/estimate.h"

namespace hyrax {
namespace {

// The cases are the pages', too: tests/unit/tools/report/page_test.mjs gives them to numbers.js.
TEST(Rounded, WritesNumbersForPeople) {
  std::ifstream cases(std::string(HYRAX_SOURCE_DIR) + "/tests/unit/sim/result/numbers.txt");
  double value = 0.0;
  int digits = 0, count = 0;
  for (std::string text; cases >> value >> digits >> text; ++count)
    EXPECT_EQ(rounded(value, digits), text) << value;
  EXPECT_GT(count, 15);
  EXPECT_EQ(rounded(std::nan("")), "–");
  EXPECT_EQ(rounded(-HUGE_VAL), "-Infinity");
  EXPECT_EQ(rounded(HUGE_VAL), "Infinity");
}

TEST(WithDecimals, KeepsThemAndHasNoNegativeZero) {
  EXPECT_EQ(with_decimals(1234.5, 2), "1,234.50");
  EXPECT_EQ(with_decimals(-0.001, 2), "0.00");
  EXPECT_EQ(with_decimals(0.125, 2), "0.13");
}

TEST(UnitText, RaisesSquares) {
  EXPECT_EQ(unit_text("px2/s2"), "px²/s²");
  EXPECT_EQ(unit_text("px/s"), "px/s");
}

TEST(Counted, HasTheSingularOfOne) {
  EXPECT_EQ(counted(1.0, "step"), "1 step");
  EXPECT_EQ(counted(11'400.0, "step"), "11,400 steps");
  EXPECT_EQ(plain_counted(1, "step"), "1 step");
  EXPECT_EQ(plain_counted(11'400, "step"), "11400 steps");
  EXPECT_EQ(plain_counted(0, "step"), "0 steps");
}

TEST(Quantile, IsBetweenItsNeighbours) {
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({1.0, 2.0}, 0.25), 1.25);
  EXPECT_EQ(quantile({7.0}, 0.95), 7.0);
}

TEST(MedianEstimate, OfFewValuesIsTheirs) {
  EXPECT_TRUE(std::isnan(median_of({}).median));
  EXPECT_EQ(median_of({4.0}).high, 4.0);
  EXPECT_EQ(median_of({4.0, 2.0}).low, 2.0);
}

// By tables of the binomial distribution: P(Binomial(n, 1/2) < k) is at most 2.5 %.
TEST(MedianEstimate, IsBetweenOrderStatistics) {
  for (const auto& [count, k] :
       {std::pair(5, 1), {6, 1}, {8, 1}, {9, 2}, {11, 2}, {12, 3}, {21, 6}, {1'000, 469}}) {
    std::vector<double> values;
    for (int value = count; value >= 1; --value) values.push_back(value);
    EXPECT_EQ(median_of(values).low, k) << count;
    EXPECT_EQ(median_of(values).high, count + 1 - k) << count;
  }
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
