// What breaks the verdicts of studies, and the final states that one of them tells apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/study/bounces/bounces.h"
#include "sim/study/frame_rate/frame_rate.h"
#include "sim/study/rest/rest_map.h"
#include "tests/unit/sim/result/described.h"

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

constexpr double kBottom_px = 952.0;

// By the listing's laws at 60 Hz.
TEST(FinalState, IsToldByTwoRowsInARow) {
  const Constants core = *shipped_core().constants;
  const double thrown = -core.restitution * core.air_drag * core.gravity_px_per_s2 / 60.0;
  const double residual = thrown / (1.0 + core.air_drag * core.restitution);
  const struct {
    double vy, next_vy;
    FinalState state;
    double above_px = 0.0;
  } cases[] = {{0.0, -0.0, FinalState::zero_speed},
               {residual, std::nextafter(residual, 0.0), FinalState::residual_speed},
               {0.0, thrown, FinalState::two_cycle},
               {thrown, 0.0, FinalState::two_cycle},
               {-3.0, 0.0, FinalState::moving},
               {0.0, 0.0, FinalState::moving, 1e-9}};
  for (const auto& [vy, next_vy, state, above_px] : cases)
    EXPECT_EQ(final_state(shipped_core(), {0.0, kBottom_px - above_px, 0.0, vy},
                          {0.0, kBottom_px, 0.0, next_vy}, 60.0),
              state)
        << vy << ", " << next_vy;
}

// It stops bounces below 8 px/s and says 5: at 120 Hz it keeps none of 5.99 px/s, at 60 Hz it leaves 11.99.
TEST(RestMap, CountsTheFinalStatesThatTheBoundariesDoNotAllow) {
  Constants laws = *shipped_core().constants;
  laws.rest_threshold_px_per_s = 8.0;
  Core lying = listing_core(laws);
  lying.constants = shipped_core().constants;
  const std::vector<RateEnds> map = rest_map(lying, {60.0, 120.0}, 5);
  EXPECT_EQ(map[0].unforeseen, 0);
  EXPECT_EQ(map[1].unforeseen, 5);
  EXPECT_EQ(map[1].count(FinalState::zero_speed), 5);
  for (const RestBoundary& boundary : rest_boundaries(lying))
    EXPECT_FALSE(boundary.agrees()) << boundary.name;
}

// At 1000 Hz it falls at 1.2 px/s.
TEST(RestMap, DoesNotTakeAFlingThatStillFallsForOneThatEnded) {
  Constants laws = *shipped_core().constants;
  laws.air_drag = 0.5;
  const std::vector<RateEnds> map = rest_map(listing_core(laws), {1000.0}, 5);
  EXPECT_EQ(map[0].count(FinalState::moving), 5);
  EXPECT_EQ(map[0].unforeseen, 0);
}

TEST(RestMap, PercentIsRoundedOnce) {
  EXPECT_EQ((RateEnds{.rate_hz = 60.0, .flings = {0, 85, 115, 0}}).percent(FinalState::residual_speed), 57.5);
}

TEST(RestVerdict, SaysWhatMovesAndWhatIsBroken) {
  RateEnds ends{.rate_hz = 60.0, .flings = {1, 0, 0, 2}, .unforeseen = 1};
  const Verdict verdict =
      rest_verdict({.boundaries = {{"a", "first", 100.0, 100.5}, {"b", "second", 50.0, {}}}, .map = {ends}});
  EXPECT_NE(described(verdict).find("settles_after,_s: : 1: '-'"), std::string::npos) << "none has settled";
  EXPECT_EQ(std::get<std::string>(verdict.text[1]), "2 of 3 flings still move after 15 s.");
  EXPECT_EQ(verdict.broken,
            (std::vector<std::string>{"first: analytic 100 Hz, measured 100.5 Hz",
                                      "second: analytic 50 Hz, measured none",
                                      "60 Hz: 2 flings still move after 15 s",
                                      "60 Hz: 1 flings end in a way that the boundaries do not allow"}));
}

}  // namespace
}  // namespace hyrax
