#include "sim/result/number_text.h"

#include <gtest/gtest.h>

#include <fstream>

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

}  // namespace
}  // namespace hyrax
