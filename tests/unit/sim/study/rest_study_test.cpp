// The study rest: its pictures as data.
#include <gtest/gtest.h>

#include "sim/study/rest/rest_map.h"

namespace hyrax {
namespace {

RateEnds ends_in(FinalState state, double rate_hz) {
  RateEnds ends{.rate_hz = rate_hz};
  ends.flings[static_cast<std::size_t>(state)] = 5;
  return ends;
}

// The picture of final states at 60 and 240 Hz: residual speed, then zero speed.
Plot state_plot(const std::vector<RestBoundary>& boundaries) {
  const RestResults results{
      .boundaries = boundaries,
      .map = {ends_in(FinalState::residual_speed, 60.0), ends_in(FinalState::zero_speed, 240.0)}};
  return std::get<std::vector<Plot>>(rest_figures(results)[0].body).front();
}

using Values = std::vector<double>;

TEST(RestFigures, StatesChangeInAStepAtTheBoundary) {
  const Plot plot = state_plot({{"some", "", 144.0, {}}});
  ASSERT_EQ(plot.series.size(), 3u);
  const Series &residual = plot.series[0], &two_cycle = plot.series[1], &zero = plot.series[2];
  EXPECT_EQ(residual.x, (Values{60.0, 144.0, 144.0, 240.0}));
  EXPECT_EQ(residual.y, (Values{100.0, 100.0, 0.0, 0.0}));
  EXPECT_EQ(two_cycle.y, two_cycle.y_low);
  EXPECT_EQ(zero.y, (Values{100.0, 100.0, 100.0, 100.0}));
  EXPECT_EQ(zero.y_low, residual.y);
  ASSERT_EQ(plot.marks.size(), 1u);
  EXPECT_EQ(plot.marks[0].at, 144.0);
}

TEST(RestFigures, WithoutABoundaryTheStepIsHalfWay) {
  EXPECT_EQ(state_plot({}).series[0].x, (Values{60.0, 120.0, 120.0, 240.0}));
}

TEST(RestFigures, BouncesAreSortedByPhaseWithALineForEachRate) {
  const RestResults results{.bounces = {{60.0, 0.5, 0.6}, {30.0, 0.9, 0.61}, {60.0, 0.1, 0.59}}};
  const Plot plot = std::get<std::vector<Plot>>(rest_figures(results)[2].body).front();
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[0].name, "30 Hz");
  EXPECT_EQ(plot.series[1].x, (Values{0.1, 0.5}));
  EXPECT_EQ(plot.series[1].y, (Values{0.59, 0.6}));
}

}  // namespace
}  // namespace hyrax
