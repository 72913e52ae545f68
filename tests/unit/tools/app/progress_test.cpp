#include <gtest/gtest.h>

#include "tools/app/command_line/progress.h"

namespace hyrax {
namespace {

TEST(Progress, EstimatesByWhatIsDoneAndNothingBefore) {
  EXPECT_EQ(progress_text(25, 100, "steps", 2.0), "25 of 100 steps, 12.5 per second, 6 s left");
  EXPECT_EQ(progress_text(100, 100, "steps", 2.0), "100 of 100 steps, 50 per second, 0 s left");
  EXPECT_EQ(progress_text(200, 100, "steps", 2.0), "200 of 100 steps, 100 per second, 0 s left");
  EXPECT_EQ(progress_text(0, 100, "steps", 2.0), "0 of 100 steps");
  EXPECT_EQ(progress_text(0, 100, "steps", 0.0), "0 of 100 steps");
}

}  // namespace
}  // namespace hyrax
