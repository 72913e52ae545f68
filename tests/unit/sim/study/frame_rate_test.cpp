// One fling on several displays.
#include <gtest/gtest.h>

#include "sim/study/frame_rate/frame_rate.h"

namespace hyrax {
namespace {

TEST(FrameRate, ThePapersMethodIsTheCoreOnEveryClock) {
  const FrameRateStudy study = study_frame_rate({24.0, 144.0}, 3);
  EXPECT_EQ(study.landings.size(), 2u * 3u * 2u * 3u);
  for (const Landing& landing : study.landings) EXPECT_TRUE(landing.is_core);
}

TEST(FrameRate, OneDisplayAloneIsIndependentOfItself) {
  for (const Independence& score : study_frame_rate({60.0}, 2).scores) EXPECT_EQ(score.score, 100.0);
}

TEST(FrameRate, ScoresAreBetweenZeroAndAHundred) {
  for (const Independence& score : study_frame_rate({24.0, 60.0, 1000.0}, 3).scores) {
    EXPECT_GE(score.score, 0.0);
    EXPECT_LE(score.score, 100.0);
    EXPECT_GT(score.way_px, 0.0);
  }
}

TEST(FrameRate, APathEndsWhereItLands) {
  const FrameRateStudy study = study_frame_rate({60.0}, 1);
  ASSERT_FALSE(study.paths.empty());
  const Landing& landing = study.landings.front();
  double last_px = 0.0;
  for (const FanPoint& point : study.paths)
    if (point.method == landing.method) last_px = point.x_px;
  EXPECT_NEAR(last_px, landing.x_px, 0.5);
}

}  // namespace
}  // namespace hyrax
