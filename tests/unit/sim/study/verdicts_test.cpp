// What breaks the verdicts of the studies bounces and frame-rate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/core/shipped_core.h"
#include "sim/study/bounces/bounces.h"
#include "sim/study/frame_rate/frame_rate.h"

namespace hyrax {
namespace {

TEST(BouncesResult, ARuleIsBrokenByExactImpactsThatLoseEnergy) {
  const KeptEnergy paper{BounceMethod::paper, 60.0, 0, 500.0, 0.5, 0.4},
      euler{BounceMethod::explicit_euler, 60.0, 0, 500.0, 1.5, 1.7},
      exact{BounceMethod::exact, 0.0, 0, 500.0, 1.0, 1.0 + 1e-10};
  EXPECT_TRUE(bounces_result({paper, euler, exact}).verdict.broken.empty());
  for (double KeptEnergy::*const part : {&KeptEnergy::minute, &KeptEnergy::ten_minutes})
    for (const auto& [kept, change] :
         {std::pair(1.0 - 1e-8, "-1e-08"), {1.0 + 1e-8, "1e-08"}, {std::nan(""), "nan"}}) {
      KeptEnergy changed = exact;
      changed.number = 7;
      changed.*part = kept;
      EXPECT_EQ(bounces_result({paper, euler, exact, changed}).verdict.broken,
                std::vector<std::string>{std::string("exact impacts: throw 7 changes its energy by ") +
                                         change + " of it, more than 1e-09"});
    }
}

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

TEST(FrameRate, AShiftIsFromTheRateNearestToSixtyHertz) {
  for (const auto& rates_hz : {std::vector{59.0, 60.2, 240.0}, std::vector{60.8, 59.75, 58.8}}) {
    const FrameRateStudy study = study_frame_rate(shipped_core(), rates_hz, 1);
    EXPECT_GT(study.shifts[0].shift_px.high, 0.0);
    EXPECT_EQ(study.shifts[1].shift_px.high, 0.0) << "from itself";
    EXPECT_GT(study.shifts[2].shift_px.high, 0.0);
  }
}

}  // namespace
}  // namespace hyrax
