// One scenario at many frame rates, by cores whose step converges and whose does not.

#include <gtest/gtest.h>

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

TEST(CoreLadder, APlaceAtOneTimeIsAtThatTimeInEveryRun) {
  Scenario scenario = fall();
  scenario.events = {{0.5, Place{{20.0, 20.0}}}};
  for (const RateRun& run : climb(core_with(1.0), scenario, {50.0, 100.0}).runs)
    EXPECT_LT(run.off_px.value(), 20.0) << run.rate_hz;
}

TEST(CoreLadder, ADistanceFromItsOwnRunIsThatOfBothErrors) {
  const auto run_at_100_hz = [](const Scenario& scenario) {
    return climb(core_with(1.0), scenario, {100.0}).runs.front();
  };
  EXPECT_NEAR(run_at_100_hz(fall()).own_px.value(), 500.0 / 60.0 - 500.0 / 100.0, 1e-6);
  Scenario scenario = fall();
  scenario.clock = {FixedRate{100.0}, {}};
  EXPECT_EQ(run_at_100_hz(scenario).own_px, 0.0);
  scenario.length = 1e6;  // Its first minute.
  EXPECT_EQ(run_at_100_hz(scenario).own_px, 0.0);
  scenario.clock.base = RecordedSteps{std::vector<double>(7000, 0.01)};
  scenario.length = {};
  EXPECT_EQ(run_at_100_hz(scenario).own_px, std::nullopt);
}

TEST(CoreLadder, AnEventBehindTheLastFrameOfACoarserRateIsNotDone) {
  Scenario scenario = fall();
  scenario.length = std::int64_t{32};
  scenario.events = {{std::int64_t{31}, Stop{}}};  // At 24 Hz the last of 13 frames begins before.
  EXPECT_LT(climb(core_with(1.0), scenario, {24.0}).runs.front().off_px.value(), 50.0);
}

TEST(CoreLadder, FramesWithoutTimeComeToAnEnd) {
  Scenario scenario = fall();
  scenario.clock = {FixedStep{0.0}, {}};
  scenario.length = kStepsMax;
  EXPECT_EQ(climb(core_with(1.0), scenario, {24.0}).until_s, 0.0);
}

TEST(CoreLadder, AnotherStepThanThePapersIsToldByItsLadder) {
  Core core = core_with(1.0);
  core.constants.reset();
  const FrameRateStudy study = study_frame_rate(core, {60.0, 144.0, 240.0}, 1);
  ASSERT_TRUE(study.ladder);
  const Verdict verdict = frame_rate_result(study).verdict;
  EXPECT_TRUE(verdict.answer.starts_with("From the run at its own clock, 144 Hz is up to "))
      << verdict.answer;
  EXPECT_TRUE(verdict.broken.empty());
}

}  // namespace
}  // namespace hyrax
