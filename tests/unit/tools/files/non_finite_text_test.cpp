// What a run that became non-finite says of itself.
#include "tools/files/non_finite_text.h"

#include <gtest/gtest.h>
#include <cmath>

namespace hyrax {
namespace {

const double kNan = std::nan("");

Scenario of_200_steps() {
  Scenario scenario;
  scenario.clock.base = FixedRate{60.0};
  scenario.length = std::int64_t{200};
  return scenario;
}

TEST(NonFiniteText, NamesFieldStepAndTime) {
  const Row last{.step = 6, .t_s = 0.1, .vx_px_per_s = kNan};
  EXPECT_EQ(non_finite_text(of_200_steps(), last), "vx is NaN from step 6 of 200 (0.10 s)");
}

TEST(NonFiniteText, NamesASpeedBeforeThePositionThatItSpoils) {
  const Row last{.step = 1, .t_s = 0.00391, .x_px = 3.0, .y_px = kNan, .vy_px_per_s = -HUGE_VAL};
  EXPECT_EQ(non_finite_text(of_200_steps(), last), "vy is infinite from step 1 of 200 (0.0039 s)");
}

TEST(NonFiniteText, IsEmptyOfAFiniteRow) { EXPECT_EQ(non_finite_text(of_200_steps(), Row{.step = 23}), ""); }

}  // namespace
}  // namespace hyrax
