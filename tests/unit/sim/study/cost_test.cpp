// Costs by a clock that the test controls.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/study/methods/cost.h"

namespace hyrax {
namespace {

TEST(MeasureCosts, MeasuresEachWorkSeparately) {
  std::int64_t now_ns = 0;
  const std::vector<std::function<void()>> works = {[&] { now_ns += 100; }, [&] { now_ns += 7'000; },
                                                    [&] { now_ns += 200'000; }};
  const Costs measured = measure_costs(works, [&] { return now_ns; }, {});
  ASSERT_EQ(measured.costs.size(), 3u);
  EXPECT_EQ(measured.costs[0].median_ns, 100.0);
  EXPECT_EQ(measured.costs[1].median_ns, 7'000.0);
  EXPECT_EQ(measured.costs[2].upper_quartile_ns, 200'000.0);
}

TEST(MeasureCosts, AMedianIgnoresAFewSlowRuns) {
  std::int64_t now_ns = 0;
  int runs = 0;
  const std::vector<std::function<void()>> works = {[&] { now_ns += ++runs % 5 == 0 ? 900'000 : 100'000; }};
  const Costs measured = measure_costs(works, [&] { return now_ns; }, {.repetitions = 40});
  EXPECT_EQ(measured.costs[0].median_ns, 100'000.0);
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

TEST(Quantile, IsBetweenItsNeighbours) {
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({1.0, 2.0}, 0.25), 1.25);
  EXPECT_EQ(quantile({7.0}, 0.95), 7.0);
}

}  // namespace
}  // namespace hyrax
