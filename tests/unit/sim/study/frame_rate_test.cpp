// One fling on several displays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "sim/core/shipped_core.h"
#include "sim/reference/exact_fling.h"
#include "sim/study/frame_rate/frame_rate.h"

namespace hyrax {
namespace {

TEST(FrameRate, TheGateBreaksByAnotherCoreAndByAMethodThatIsNoSteadier) {
  FrameRateStudy study = study_frame_rate(shipped_core(), {24.0, 144.0}, 30);
  EXPECT_EQ(frame_rate_result(study).verdict.broken, std::vector<std::string>{});
  for (const double rate_hz : {24.0, 144.0}) {
    const auto landing = std::ranges::find_if(study.landings, [&](const Landing& each) {
      return each.method == 0 && each.clock == DisplayClock::jittered && each.rate_hz == rate_hz;
    });
    ASSERT_NE(landing, study.landings.end());
    landing->is_core = false;
  }
  study.steadier_by_time = {Share{40, 60}, Share{37, 60}, Share{0, 4}};
  EXPECT_EQ(frame_rate_result(study).verdict.broken,
            (std::vector<std::string>{
                "24 Hz, jittered: the method called the paper's step differs from the core",
                "frames jittered by 2 ms (normal): drag and friction by time spread less in 37 of 60 flings "
                "(49 .. 73 %): they are no more independent of the frame rate than the paper's step",
                "one frame in twenty missed: drag and friction by time spread less in 0 of 4 flings "
                "(0 .. 49 %): they are no more independent of the frame rate than the paper's step"}));
}

// The drawn fling, flown here in steps of a second: whatever the rate, its place is one.
TEST(FrameRate, TheExactFlingSettlesAtOnePlace) {
  ExactFling exact;
  exact.start(kDrawnFling, kDrawnBounds);
  for (double t_s = 1.0; t_s < 16.0; t_s += 1.0) (void)exact.at(t_s);
  const double place_px = exact.at(16.0).x_px;
  const FrameRateStudy study = study_frame_rate(shipped_core(), {24.0, 240.0}, 4);
  for (const Landing& landing : study.landings) {
    if (landing.fling != 0) continue;
    EXPECT_NEAR(landing.off_px, std::fabs(landing.x_px - place_px), 1e-9);
  }
  std::vector<double> offs_px;
  for (std::size_t fling = 0; fling <= 4; ++fling) offs_px.push_back(study.landings[5 + fling].off_px);
  EXPECT_EQ(study.shifts[1].off_px.median, quantile(offs_px, 0.5)) << "at 240 Hz";
  EXPECT_GT(study.shifts[1].off_px.low, 0.0);
}

TEST(FrameRate, AShiftIsFromTheRateNearestToSixtyHertz) {
  for (const auto& rates_hz : {std::vector{59.0, 60.2, 240.0}, std::vector{60.8, 59.75, 58.8}}) {
    const FrameRateStudy study = study_frame_rate(shipped_core(), rates_hz, 1);
    EXPECT_GT(study.shifts[0].shift_px.high, 0.0);
    EXPECT_EQ(study.shifts[1].shift_px.high, 0.0) << "from itself";
    EXPECT_GT(study.shifts[2].shift_px.high, 0.0);
  }
}

TEST(ManyFlings, AreTheSameOnEveryClockWithSeveralJitterSeeds) {
  const ManyFlings steady({FixedRate{60.0}, {}}, 1.0, 100);
  const ManyFlings jittered({FixedRate{240.0}, Jitter{Jitter::Kind::normal, 0.002, 0}}, 1.0, 100);
  std::set<std::uint64_t> seeds;
  for (std::int64_t fling = 0; fling < 100; ++fling) {
    EXPECT_TRUE(same_bits(steady.start(fling), jittered.start(fling)));
    seeds.insert(jittered.clock(fling).jitter->seed);
  }
  EXPECT_EQ(seeds.size(), static_cast<std::size_t>(kJitterSeeds));
}

}  // namespace
}  // namespace hyrax
