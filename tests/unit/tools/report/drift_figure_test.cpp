#include "tools/report/drift_figure.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

// Arcs of ten rows each, a second long, that end at the ground.
struct MeasuredRun : DriftRun {
  explicit MeasuredRun(std::size_t count) {
    for (std::size_t arc = 0; arc < count; ++arc) {
      const auto first = static_cast<std::int64_t>(10 * arc);
      const auto end_s = static_cast<double>(arc + 1);
      arcs.push_back({.first_step = first,
                      .last_step = first + 9,
                      .t_s = end_s,
                      .duration_s = 1.0,
                      .energy_parts = {.gravity = -12'000.0}});
      contacts.push_back({.step = first + 10, .t_s = end_s, .energy_parts = {.lift = 6'000.0}});
      for (std::int64_t row = 0; row < 10; ++row) {
        const auto n = static_cast<double>(row);
        rows.push_back({arc,
                        {.step = first + row,
                         .t_s = end_s - 1.0 + n / 9.0,
                         .energy_drift_px2_per_s2 = -12'000.0 * n / 9.0}});
        whole_rows.push_back({rows.back().errors.t_s, n});
      }
    }
    steps = static_cast<std::int64_t>(10 * count);
    simulated_s = static_cast<double>(count);
    summary.arcs = summary.contacts = static_cast<std::int64_t>(count);
    summary.secular_px_per_s = -10.0;
    summary.causes = {.gravity = -10.0 * simulated_s, .lift = 5.0 * simulated_s};
    whole.run = WholeRun{.end_px = 12.0};
  }
};

std::vector<Plot> plots_of(const DriftRun& run) {
  return std::get<std::vector<Plot>>(drift_figure(run).body);
}

TEST(DriftFigure, SaysWhatARunLosesAndWhatLiftsGiveBack) {
  MeasuredRun run(3);
  run.scenario.name = "x";
  EXPECT_EQ(drift_figure(run).title,
            "x loses 10 px of height a second in flight; lifts out of walls give half back");
  run.summary.causes.lift = 9.0;
  EXPECT_EQ(drift_figure(run).title,
            "x loses 10 px of height a second in flight; lifts out of walls give 30 % back");
  run.summary.causes.lift = 60.0;
  EXPECT_EQ(drift_figure(run).title,
            "x loses 10 px of height a second in flight; lifts out of walls give 2 times that back");
  run.summary.causes.lift = 0.1;
  run.summary.secular_px_per_s = 0.25;
  EXPECT_EQ(drift_figure(run).title, "x gains 0.25 px of height a second in flight");
}

// At the end of each arc gravity took 10 px more, and its contact then gave 5 back.
TEST(DriftFigure, HasTheDriftOfFlightsOneAfterTheOther) {
  const Plot energy = plots_of(MeasuredRun(3))[1];
  const Series &gravity = energy.series[0], &lift = energy.series[2], &drift = energy.series[4];
  EXPECT_EQ(gravity.y.back(), -30.0);
  EXPECT_EQ(lift.y.back(), 15.0);
  EXPECT_EQ(drift.y.back(), -15.0);
  EXPECT_EQ(*std::ranges::min_element(drift.y), -20.0) << "of two arcs and the third, less two lifts";
}

TEST(DriftFigure, EndsWhereTheSpriteIsInRestingContact) {
  MeasuredRun run(3);
  run.summary.rests = {{2.0, 3.0}};
  run.summary.is_resting_at_end = true;
  const Figure figure = drift_figure(run);
  EXPECT_EQ(figure.note, "in resting contact from 2 s on");
  for (const Plot& plot : plots_of(run)) {
    EXPECT_EQ(plot.x.high, 2.0);
    for (const Series& series : plot.series) EXPECT_LE(series.x.back(), 2.0) << series.name;
  }
  EXPECT_EQ(plots_of(run)[0].top_dots.size(), 1u) << "the bounces before it";
}

TEST(DriftFigure, LeavesOutWhatRestsInBetween) {
  MeasuredRun run(3);
  run.summary.rests = {{1.0, 2.0}};
  const Plot energy = plots_of(run)[1];
  EXPECT_EQ(plots_of(run)[0].top_dots.size(), 2u);
  EXPECT_EQ(energy.series[2].y.back(), 10.0) << "the lifts of two bounces";
}

TEST(DriftFigure, MarksNoMoreThanReadersCanDistinguish) {
  EXPECT_EQ(plots_of(MeasuredRun(80))[0].top_dots.size(), 80u);
  EXPECT_TRUE(plots_of(MeasuredRun(81))[0].top_dots.empty());
  MeasuredRun run(2);
  run.scenario = fling_at(60.0, 100, {13, {std::int64_t{5}, Stop{}}});
  EXPECT_EQ(plots_of(run)[0].marks.size(), 12u);
  run.scenario = fling_at(
      60.0, 100, {{std::int64_t{5}, Stop{}}, {std::int64_t{6}, Place{}}, {std::int64_t{90}, Stop{}}});
  EXPECT_EQ(plots_of(run)[0].marks.size(), 1u) << "not a hand's way, nor what comes after the last flight";
}

}  // namespace
}  // namespace hyrax
