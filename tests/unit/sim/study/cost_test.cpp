// Costs by a clock that the test controls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "sim/scenario/split_mix64.h"
#include "sim/study/methods/cost.h"

namespace hyrax {
namespace {

TEST(MeasureCosts, MeasuresEachWorkSeparately) {
  std::int64_t now_ns = 0;
  const std::vector<std::function<void()>> works = {[&] { now_ns += 100; }, [&] { now_ns += 7'000; },
                                                    [&] { now_ns += 200'000; }};
  const Costs measured = measure_costs(works, [&] { return now_ns; }, {});
  ASSERT_EQ(measured.costs.size(), 3u);
  EXPECT_EQ(measured.costs[0].time_ns.median, 100.0);
  EXPECT_EQ(measured.costs[1].time_ns.median, 7'000.0);
  EXPECT_EQ(measured.costs[2].time_ns.high, 200'000.0);
}

TEST(MeasureCosts, AMedianIgnoresAFewSlowRuns) {
  std::int64_t now_ns = 0;
  int runs = 0;
  const std::vector<std::function<void()>> works = {[&] { now_ns += ++runs % 5 == 0 ? 900'000 : 100'000; }};
  const Costs measured = measure_costs(works, [&] { return now_ns; }, {.repetitions = 40});
  EXPECT_EQ(measured.costs[0].time_ns.median, 100'000.0);
}

TEST(MeasureCosts, TheOrderIsMixedAndEveryWorkHasAllItsSamples) {
  std::int64_t now_ns = 0;
  std::vector<int> order;
  std::vector<std::function<void()>> works;
  for (int work = 0; work < 4; ++work)
    works.push_back([&, work] {
      now_ns += 100'000;
      order.push_back(work);
    });
  const Costs measured = measure_costs(works, [&] { return now_ns; }, {.repetitions = 25});
  EXPECT_EQ(measured.costs.size(), works.size());
  order.erase(order.begin(), order.begin() + 8);  // Warming up, and how long a run takes.
  for (int work = 0; work < 4; ++work) EXPECT_EQ(std::count(order.begin(), order.end(), work), 25);
  EXPECT_FALSE(std::is_sorted(order.begin(), order.end()));
  int in_turn = 0;
  for (std::size_t i = 1; i < order.size(); ++i) in_turn += order[i] == (order[i - 1] + 1) % 4;
  EXPECT_LT(in_turn, 50);
}

TEST(MeasureCosts, TheProbeDetectsAClockThatChanges) {
  std::int64_t now_ns = 0;
  std::int64_t tick_ns = 100;
  const std::vector<std::function<void()>> works = {[&] { now_ns += 100'000; }};
  const auto steady = [&] { return now_ns += tick_ns; };
  EXPECT_EQ(measure_costs(works, steady, {.repetitions = 400}).probe.drift_rel, 0.0);
  const auto slowing = [&] { return now_ns += tick_ns++; };
  EXPECT_GT(measure_costs(works, slowing, {.repetitions = 400}).probe.drift_rel, 0.5);
}

TEST(MeasureCosts, EveryRoundHasEveryWorkOnce) {
  std::int64_t now_ns = 0;
  std::vector<std::size_t> order;
  std::vector<std::function<void()>> works;
  for (std::size_t work = 0; work < 4; ++work)
    works.push_back([&, work] {
      now_ns += 100'000;
      order.push_back(work);
    });
  EXPECT_EQ(measure_costs(works, [&] { return now_ns; }, {.repetitions = 9}).costs[3].rounds_ns.size(), 9u);
  for (std::size_t first = 8; first < order.size(); first += 4)
    EXPECT_EQ(
        (std::set(order.begin() + std::ptrdiff_t(first), order.begin() + std::ptrdiff_t(first + 4)).size()),
        4u);
}

TEST(MeasureCosts, AnUnsteadyClockMeasuresNothing) {
  std::int64_t now_ns = 0, tick_ns = 100;
  const Costs measured =
      measure_costs({[&] { now_ns += 100'000; }}, [&] { return now_ns += tick_ns++; }, {.repetitions = 400});
  EXPECT_FALSE(measured.costs[0].is_measured());
  EXPECT_TRUE(std::isnan(measured.costs[0].time_ns.median));
  EXPECT_EQ(unsteady_text({.median_ns = 1.0, .drift_rel = 0.4}),
            "not measured: clock unsteady (drift 40 %, at most 25 %)");
  EXPECT_EQ(unsteady_text({.median_ns = 1.0, .drift_rel = 0.2}), "");
}

TEST(IsCheaper, OnlyBeyondTheNoise) {
  const Cost steady = cost_of({10, 10, 10, 10, 10, 10, 10, 10, 10});
  const Cost cheaper = cost_of({9, 9.5, 9, 9.5, 9, 9.5, 9, 9.5, 9});
  const Cost noisy = cost_of({9, 11, 9, 11, 9, 11, 9, 11, 9});
  EXPECT_TRUE(is_cheaper(cheaper, steady));
  EXPECT_FALSE(is_cheaper(steady, cheaper));
  EXPECT_LT(noisy.time_ns.median, steady.time_ns.median);
  EXPECT_FALSE(is_cheaper(noisy, steady));
  EXPECT_FALSE(is_cheaper(Cost(), steady));
}

// A machine that slows down from round to round changes neither a ratio nor a part that is taken off.
TEST(IsCheaper, ComparesRoundByRound) {
  const Cost a = cost_of({10, 20, 30, 40, 50, 60, 70, 80, 90});
  const Cost b = cost_of({11, 21, 31, 41, 51, 61, 71, 81, 91});
  EXPECT_TRUE(is_cheaper(a, b));
  const Cost difference = difference_of(b, a, 2.0);
  EXPECT_EQ(difference.time_ns.low, 0.5);
  EXPECT_EQ(difference.time_ns.high, 0.5);
}

TEST(Quantile, IsBetweenItsNeighbours) {
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({1.0, 2.0}, 0.25), 1.25);
  EXPECT_EQ(quantile({7.0}, 0.95), 7.0);
}

// Of 21 values, P(median of a resample <= the 6th) is 0.018 and of the 7th 0.056.
TEST(MedianEstimate, HasItsBootstrapInterval) {
  std::vector<double> values(21);
  std::iota(values.begin(), values.end(), 1.0);
  const MedianEstimate estimate = median_of(values);
  EXPECT_EQ(estimate.median, 11.0);
  EXPECT_EQ(estimate.low, 7.0);
  EXPECT_EQ(estimate.high, 15.0);
  EXPECT_TRUE(std::isnan(median_of({}).median));
  EXPECT_EQ(median_of({4.0}).high, 4.0);
  EXPECT_EQ(median_of({4.0, 2.0}).low, 2.0);
}

// The same by drawing 20,000 resamples.
TEST(MedianEstimate, IsWhatResamplingGives) {
  std::vector<double> values, medians;
  for (std::uint64_t k = 0; k < 21; ++k) values.push_back(split_mix64_unit(1, k));
  std::uint64_t draw = 0;
  for (int resample = 0; resample < 20'000; ++resample) {
    std::vector<double> drawn;
    for (int value = 0; value < 21; ++value) drawn.push_back(values[split_mix64(2, draw++) % 21]);
    medians.push_back(quantile(drawn, 0.5));
  }
  EXPECT_EQ(median_of(values).low, quantile(medians, 0.025));
  EXPECT_EQ(median_of(values).high, quantile(medians, 0.975));
}

// Newcombe (1998), Statistics in Medicine 17, table I.
TEST(Share, HasWilsonsInterval) {
  Share share;
  for (int i = 0; i < 263; ++i) share.add(i < 81);
  EXPECT_NEAR(share.low(), 0.2553, 5e-5);
  EXPECT_NEAR(share.high(), 0.3662, 5e-5);
  EXPECT_EQ((Share{0, 20}.low()), 0.0);
  EXPECT_NEAR((Share{0, 20}.high()), 0.1611, 5e-5);
}

}  // namespace
}  // namespace hyrax
