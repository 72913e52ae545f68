// One scenario at many frame rates, by cores whose step converges and whose does not.
#include "sim/study/frame_rate/core_ladder.h"

#include <gtest/gtest.h>
#include <cmath>

#include "sim/core/listing_core.h"
#include "sim/study/frame_rate/frame_rate.h"

namespace hyrax {
namespace {

// Falls for a second in a room so large that it meets no wall.
Scenario fall() {
  Scenario scenario;
  scenario.name = "fall";
  scenario.clock = {FixedRate{60.0}, {}};
  scenario.length = 1.0;
  scenario.window = {100'000, 100'000};
  scenario.sprite = {10, 10};
  scenario.start = {50'000.0, 50'000.0};
  return scenario;
}

Core core_with(double air_drag) {
  return listing_core({.gravity_px_per_s2 = 1000.0,
                       .restitution = 0.5,
                       .air_drag = air_drag,
                       .ground_friction = 1.0,
                       .rest_threshold_px_per_s = 1.0});
}

TEST(CoreLadder, WithoutDragItsErrorHalvesWithEachDoubling) {
  const RateLadder ladder = climb(core_with(1.0), fall(), {50.0, 100.0});
  const auto error_px = [](double rate_hz) { return 0.5 * 1000.0 / rate_hz; };
  ASSERT_EQ(ladder.runs.size(), 3U);
  for (const RateRun& run : ladder.runs)
    EXPECT_NEAR(run.off_px.value(), error_px(run.rate_hz) - error_px(kFinestRate_hz), 1e-6) << run.rate_hz;
  EXPECT_NEAR(ladder.gain(), 2.0, 1e-6);
  EXPECT_TRUE(ladder.converges());
}

TEST(CoreLadder, DragByTheFrameDoesNotConverge) {
  EXPECT_FALSE(climb(core_with(0.99), fall(), {50.0}).converges());
}

TEST(CoreLadder, ARunThatEndsEarlyHasAFaultAndNoDistance) {
  Scenario scenario = fall();
  scenario.start_velocity = {0.0, 1e12};
  const Core explosive = listing_core({.gravity_px_per_s2 = 1e300,
                                       .restitution = 1.0,
                                       .air_drag = 1e20,
                                       .ground_friction = 1.0,
                                       .rest_threshold_px_per_s = 0.0});
  for (const RateRun& run : climb(explosive, scenario, {50.0}).runs) {
    EXPECT_FALSE(run.off_px) << run.rate_hz;
    ASSERT_EQ(run.faults.size(), 1U) << run.rate_hz;
    EXPECT_TRUE(run.faults[0].starts_with("not finite at step ")) << run.faults[0];
  }
}

TEST(CoreLadder, AnotherStepThanThePapersIsToldByItsLadder) {
  Core core = core_with(1.0);
  core.constants.reset();
  const FrameRateStudy study = study_frame_rate(core, {60.0, 240.0}, 1);
  ASSERT_TRUE(study.ladder);
  const Verdict verdict = frame_rate_result(study).verdict;
  EXPECT_TRUE(verdict.answer.starts_with("From 2000 Hz, 60 Hz is up to ")) << verdict.answer;
  EXPECT_TRUE(verdict.broken.empty());
}

}  // namespace
}  // namespace hyrax
