// The apex and the position at each second.
#include "sim/trajectory/waypoints.h"

#include <gtest/gtest.h>

#include <limits>

namespace hyrax {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Waypoints waypoints_of(const std::vector<Row>& rows) {
  WaypointMeter meter(static_cast<std::int64_t>(rows.size()) - 1);
  for (const Row& row : rows) {
    Columns batch;
    batch.append(row);
    meter.rows(batch);
  }
  return meter.take();
}

// Frames of one dt; y by row.
std::vector<Row> run_of(double dt_s, const std::vector<double>& y_px) {
  std::vector<Row> rows;
  for (std::size_t step = 0; step < y_px.size(); ++step)
    rows.push_back({.step = static_cast<std::int64_t>(step),
                    .t_s = static_cast<double>(step) * dt_s,
                    .dt_s = step == 0 ? 0.0 : dt_s,
                    .y_px = y_px[step]});
  return rows;
}

std::vector<std::int64_t> steps_at_seconds(const Waypoints& waypoints) {
  std::vector<std::int64_t> steps;
  for (const Row& row : waypoints.at_seconds) steps.push_back(row.step);
  return steps;
}

TEST(Waypoints, TheApexIsTheFirstOfTheHighestRows) {
  EXPECT_EQ(waypoints_of(run_of(0.25, {5.0, 3.0, 4.0, 3.0, 9.0})).apex.step, 1);
  EXPECT_EQ(waypoints_of(run_of(0.25, {1.0, 3.0})).apex.step, 0);
  EXPECT_EQ(waypoints_of(run_of(0.25, {5.0})).apex.y_px, 5.0) << "a run of no frames";
  EXPECT_EQ(waypoints_of(run_of(0.25, {5.0, kNan, 4.0})).apex.step, 2) << "a NaN is none";
}

TEST(Waypoints, ARowIsShownUntilTheNext) {
  const auto steps_of = [](double dt_s, std::size_t rows) {
    return steps_at_seconds(waypoints_of(run_of(dt_s, std::vector<double>(rows))));
  };
  using Steps = std::vector<std::int64_t>;
  EXPECT_EQ(steps_of(0.25, 1), Steps());
  EXPECT_EQ(steps_of(0.25, 10), (Steps{4, 8}));
  EXPECT_EQ(steps_of(0.4, 7), (Steps{2, 5}));
  EXPECT_EQ(steps_of(2.5, 3), (Steps{0, 0, 1, 1, 2}));
  EXPECT_EQ(steps_of(0.5, 100).size(), 10u) << "they end after ten seconds";
}

TEST(Waypoints, ATimeMayBeOffByRounding) {
  std::vector<Row> rows = run_of(0.5, std::vector<double>(5));
  rows[2].t_s = std::nextafter(1.0, 2.0);
  rows[4].t_s = std::nextafter(2.0, 0.0);
  EXPECT_EQ(steps_at_seconds(waypoints_of(rows)), (std::vector<std::int64_t>{2, 4}));
  rows[2].t_s = 1.0 + 1e-6;
  rows[4].t_s = 2.0 - 1e-6;
  EXPECT_EQ(steps_at_seconds(waypoints_of(rows)), (std::vector<std::int64_t>{1}));
}

}  // namespace
}  // namespace hyrax
