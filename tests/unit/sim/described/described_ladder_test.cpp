#include "sim/described/described_ladder.h"

#include <gtest/gtest.h>
#include <algorithm>

#include "tests/unit/sim/described/core_for_test.h"

namespace hyrax {
namespace {

// Falls by the semi-implicit Euler step, whose error after t seconds is g t dt / 2.
struct Faller {
  static constexpr double kGravity_px_per_s2 = 100.0;
  double y = 0.0;
  double vy = 0.0;
  double drift = 0.0;
  void step(double dt_s) {
    vy += kGravity_px_per_s2 * dt_s;
    y += vy * dt_s + drift;
  }
  void state(auto&& see) {
    see("y_px", y);
    see("vy_px_per_s", vy);
  }
  void parameters(auto&& see) { see("drift", drift); }
  void actions(auto&& see) {
    see("lift", [&] { y -= 50.0; });
  }
};

const std::vector<double> kRates_hz = {50.0, 100.0};

TEST(RateLadder, ADistanceIsThatOfTheStepsErrorAndHalvesWithEachDoubling) {
  const RateLadder ladder = climb(core_for_test<Faller>(), scenario_for_test(120), kRates_hz, {});
  ASSERT_EQ(ladder.runs.size(), 3U);
  const auto error_px = [](double rate_hz) { return 0.5 * Faller::kGravity_px_per_s2 * 2.0 / rate_hz; };
  for (const RateRun& run : ladder.runs)
    EXPECT_NEAR(run.off_px.value(), error_px(run.rate_hz) - error_px(kFinestRate_hz), 1e-9) << run.rate_hz;
  EXPECT_NEAR(ladder.gain(), 2.0, 1e-6);
  EXPECT_TRUE(ladder.converges());
  EXPECT_EQ(ladder.until_s, 2.0);
  EXPECT_FALSE(ladder.is_cut);
}

TEST(RateLadder, WhatMovesByTheFrameDoesNotConverge) {
  DescribedScenario scenario = scenario_for_test(120);
  scenario.parameters = {{0, word_of(0.01)}};
  const RateLadder ladder = climb(core_for_test<Faller>(), scenario, kRates_hz, {});
  EXPECT_LT(ladder.gain(), 1.0);
  EXPECT_FALSE(ladder.converges());
}

TEST(RateLadder, DoublingsThatDoNotEachChangeLessThanTheOneBeforeDecideNothing) {
  const auto ladder_of = [](const std::vector<double>& doubling_px) {
    return RateLadder{.doubling_px = doubling_px};
  };
  EXPECT_TRUE(ladder_of({8.0, 4.0, 2.0, 1.0}).converges());
  EXPECT_FALSE(ladder_of({8.0, 4.0, 2.0, 1.0}).is_undecided());
  EXPECT_TRUE(ladder_of({3.0, 0.0, 0.0, 0.0}).converges());
  EXPECT_FALSE(ladder_of({8.0, 2.0, 3.0, 1.0}).converges());
  EXPECT_TRUE(ladder_of({8.0, 2.0, 3.0, 1.0}).is_undecided());
  EXPECT_FALSE(ladder_of({8.0, 8.1, 8.2, 7.9}).is_undecided());
}

TEST(RateLadder, EventsKeepTheirTimesAndHitchesAreLeftOut) {
  DescribedScenario scenario = scenario_for_test(120);
  scenario.events = {event_for_test(60, Hitch{0.25}), event_for_test(61, Act{0, {}})};
  const DescribedCore core = core_for_test<Faller>();
  const RateLadder ladder = climb(core, scenario, kRates_hz, {});
  EXPECT_TRUE(ladder.has_hitches);
  EXPECT_EQ(ladder.until_s, 2.0);
  // The lift is at one time in every run: none is off by its 50 px beside it.
  for (const RateRun& run : ladder.runs) EXPECT_LT(run.off_px.value(), 3.0) << run.rate_hz;
}

TEST(RateLadder, AnEventBehindTheLastFrameOfACoarserRateIsNotDone) {
  DescribedScenario scenario = scenario_for_test(32);
  scenario.events = {event_for_test(31, Act{0, {}})};  // At 24 Hz the last of 13 frames begins before.
  std::vector<std::int64_t> steps;
  const RateLadder ladder =
      climb(core_for_test<Faller>(), scenario, {24.0}, [&](const DescribedSummary& summary) {
        steps.push_back(summary.steps);
        return summary.early_end ? std::vector{summary.early_end->what} : std::vector<std::string>();
      });
  EXPECT_EQ(ladder.runs.front().faults, std::vector<std::string>());
  EXPECT_EQ(std::ranges::count(steps, 13), 1);
  EXPECT_LT(ladder.runs.front().off_px.value(), 3.0);
}

TEST(RateLadder, NoMoreThanAMinuteIsPlayedAndNoInputOfEachFrame) {
  // As long as a file allows: nothing behind the minute costs time or memory.
  const RateLadder ladder = climb(core_for_test<Faller>(), scenario_for_test(kStepsMax), {60.0}, {});
  EXPECT_EQ(ladder.until_s, 60.0);
  EXPECT_TRUE(ladder.is_cut);
  DescribedScenario scenario = scenario_for_test(10);
  EXPECT_EQ(why_one_rate(scenario), "");
  scenario.input_arrays.push_back({});
  EXPECT_EQ(why_one_rate(scenario), "an input has a value for each frame");
}

}  // namespace
}  // namespace hyrax
