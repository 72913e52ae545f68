// What the study frame-rate measures and what breaks its verdict.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
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
  study.shifts[1].settled.count -= 2;
  study.steadier_by_time = {Share{40, 60}, Share{37, 60}, Share{0, 4}};
  EXPECT_EQ(frame_rate_result(study).verdict.broken,
            (std::vector<std::string>{
                "24 Hz, jittered: the method called the paper's step differs from the core",
                "144 Hz, the paper's step: 2 of 31 flings have not settled within 16 s",
                "frames jittered by 2 ms (normal): drag and friction by time spread less in 37 of 60 flings "
                "(49 .. 73 %): they are no more independent of the frame rate than the paper's step",
                "one frame in twenty missed: drag and friction by time spread less in 0 of 4 flings "
                "(0 .. 49 %): they are no more independent of the frame rate than the paper's step"}));
}

// At 60 Hz vy ends in a two-cycle or at the residual speed, at 144 Hz at 0; vx shrinks on and on.
TEST(FrameRate, ASettledSpriteStandsStillAndSomeOfItsSpeedsStillChange) {
  const FrameRateStudy study = study_frame_rate(shipped_core(), {60.0, 144.0}, 30);
  for (const std::size_t rate : {0u, 1u}) {
    const DisplayShift& at = study.shifts[rate];
    EXPECT_EQ(at.settled.count, 31);
    EXPECT_EQ(at.moves_px, 0.0);
    EXPECT_EQ(at.changing[0] + at.changing[1], 0);
    EXPECT_EQ(at.changing[2], 31);
    EXPECT_EQ(at.changing[3] > 0, rate == 0);
    EXPECT_LT(at.changing[3], 31);
  }
}

TEST(FrameRate, PlaysFlingsForAsLongAsTheCoresConstantsAskAndSaysWhereThatIsCut) {
  Constants laws{980.0, 0.9, 0.9995, 0.7, 8.0};
  const FrameRateStudy lively = study_frame_rate(listing_core(laws), {24.0, 240.0}, 20);
  EXPECT_GT(lively.until_s, 25.0);
  EXPECT_FALSE(lively.is_cut);
  for (const DisplayShift& shift : lively.shifts)
    EXPECT_TRUE(shift.settled.count == 21 || shift.clock == DisplayClock::missing);
  laws.restitution = laws.air_drag = 1.0;
  const FrameRateStudy endless = study_frame_rate(listing_core(laws), {24.0, 240.0}, 20);
  EXPECT_TRUE(endless.is_cut);
  EXPECT_LT(endless.shifts[0].settled.count, 21);
  const Verdict verdict = frame_rate_result(endless).verdict;
  EXPECT_NE(std::get<std::string>(verdict.text[4]).find("within 60 s"), std::string::npos);
  EXPECT_NE(std::get<std::string>(verdict.text[4]).find("Some may take longer"), std::string::npos);
  for (const std::string& sentence : verdict.broken)
    EXPECT_EQ(sentence.find("not settled"), std::string::npos) << sentence;
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
