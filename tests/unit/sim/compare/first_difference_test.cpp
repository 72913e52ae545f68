// The first field in which two rows differ.
#include <gtest/gtest.h>

#include <limits>

#include "sim/compare/run_comparer.h"
#include "tests/unit/sim/compare/played_run.h"

namespace hyrax {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Row some_row() {
  return {.step = 7,
          .t_s = 0.5,
          .dt_s = 1.0 / 60.0,
          .x_px = 300.0,
          .y_px = 500.0,
          .vx_px_per_s = -2400.0,
          .vy_px_per_s = 1e-300,
          .contact = 3};
}

TEST(FirstDifference, ComparesTheFieldsInOrder) {
  Row actual = some_row();
  for (auto field = kRowFields.rbegin(); field != kRowFields.rend(); ++field) {
    actual = with_fault(actual, field->name);
    EXPECT_EQ(first_difference(some_row(), actual)->field, field->name);
  }
}

TEST(FirstDifference, DistinguishesSignedZeros) {
  Row expected = some_row();
  Row actual = some_row();
  expected.vx_px_per_s = 0.0;
  actual.vx_px_per_s = -0.0;
  const auto first = first_difference(expected, actual);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->field, "vx");
  EXPECT_EQ(first->ulps, 0u);
}

TEST(FirstDifference, FindsANanDifferentFromEverything) {
  for (const RowField& field : kRowFields) {
    if (field.name == "contact") continue;
    Row with_nan = some_row();
    with_nan.*kFaultyFields.at(field.name) = kNan;
    for (const auto& [expected, actual] :
         {std::pair{some_row(), with_nan}, {with_nan, some_row()}, {with_nan, with_nan}}) {
      const auto first = first_difference(expected, actual);
      ASSERT_TRUE(first) << field.name;
      EXPECT_EQ(first->field, field.name);
      EXPECT_EQ(first->ulps, std::nullopt);
    }
  }
}

}  // namespace
}  // namespace hyrax
