#include "sim/reference/drift_meter.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/reference/margin.h"
#include "tests/unit/sim/reference/test_run.h"

namespace hyrax {
namespace {

// A flight of 1 s from vy = -900 px/s by the shipped core.
ArcErrors one_second_at(double rate_hz) {
  Measured measured;
  measure(open_sky({0.0, -900.0}, rate_hz, static_cast<std::int64_t>(rate_hz)), measured);
  return measured.arcs.at(0);
}

ArcErrors measured_arc(const StepDouble& step, const Scenario& scenario, const Model& model = {}) {
  Measured measured;
  measure(scenario, fly_by(step, scenario), measured, nullptr, model);
  return measured.arcs.at(0);
}

// The numbers that the step's order gives: 600 h - 0.16 px, to their last digit.
TEST(TruncationError, OfASecondOfFlightHalvesWithTheFrame) {
  EXPECT_NEAR(one_second_at(30).truncation_px, 19.84, 0.005);
  EXPECT_NEAR(one_second_at(60).truncation_px, 9.84, 0.005);
  EXPECT_NEAR(one_second_at(120).truncation_px, 4.84, 0.005);
  EXPECT_NEAR(one_second_at(240).truncation_px, 2.34, 0.005);
  EXPECT_NEAR(one_second_at(480).truncation_px, 1.09, 0.005);
}

// v_n - v(t) = -(G h / 2)(1 - a^n), to the second order in 1 - a.
TEST(TruncationError, OfSpeedIsHalfAFrameOfGravityTimesTheDampedPart) {
  EXPECT_NEAR(one_second_at(60).truncation_px_per_s, 10.0 * (1.0 - std::pow(0.999, 60)), 1e-3);
}

TEST(ModelError, GrowsWithTheFrameRate) {
  EXPECT_NEAR(one_second_at(60).model_px, 9.84, 0.005);
  EXPECT_NEAR(one_second_at(240).model_px, 42.3, 0.05);
  EXPECT_NEAR(one_second_at(1920).model_px, 232.7, 0.05);
}

// 304 px when the second is over, and more on the way: the paper's step does not converge, since
// its drag acts once a frame however short the frame is.
TEST(ModelError, DoesNotVanishWithTheFrame) {
  Measured measured(true);
  measure(open_sky({0.0, -900.0}, 7680.0, 7680), measured);
  EXPECT_NEAR(measured.rows.back().model_px, 304.13, 0.005);
  EXPECT_GT(measured.arcs.at(0).model_px, 304.13);
}

TEST(ModelError, IsOfFirstOrderWhereDragIsNormalisedByRate) {
  const auto error_px = [](double rate_hz) {
    const double air_drag = std::pow(0.999, 60.0 / rate_hz);
    const Scenario scenario = open_sky({0.0, -900.0}, rate_hz, static_cast<std::int64_t>(rate_hz));
    const Model model{.air_drag = air_drag, .model_rate_hz = rate_hz};
    return measured_arc(paper_step(air_drag), scenario, model).model_px;
  };
  for (double rate_hz = 30.0; rate_hz < 1920.0; rate_hz *= 2.0)
    EXPECT_NEAR(std::log2(error_px(rate_hz) / error_px(2.0 * rate_hz)), 1.0, 0.02) << rate_hz;
}

TEST(ImplementationError, DetectsDragBeforeGravity) {
  const auto drag_first = [](Row& row) {
    row.vx_px_per_s *= 0.999;
    row.vy_px_per_s *= 0.999;
    row.vy_px_per_s += 1200.0 * row.dt_s;
    row.x_px += row.vx_px_per_s * row.dt_s;
    row.y_px += row.vy_px_per_s * row.dt_s;
  };
  EXPECT_GT(measured_arc(drag_first, open_sky({400.0, -900.0}, 60.0, 60)).implementation_px, 0.1);
}

TEST(StepsThatDiffer, IncludeOneUnitInTheLastPlace) {
  const Scenario scenario = open_sky({407.0, -903.0}, 60.0, 200);
  Columns rows = rows_of(scenario);
  rows.vy_px_per_s.back() = std::nextafter(rows.vy_px_per_s.back(), 0.0);
  Measured measured;
  measure(scenario, rows, measured);
  EXPECT_EQ(measured.summary.differing_steps, 1);
}

TEST(ArcErrors, HaveNoErrorWhereNothingMoves) {
  Scenario scenario = open_sky({0.0, 0.0}, 60.0, 5);
  scenario.clock.base = FixedStep{0.0};
  Measured measured;
  measure(scenario, measured);
  const ArcErrors& arc = measured.arcs.at(0);
  EXPECT_EQ(arc.implementation_px, 0.0);
  EXPECT_EQ(arc.truncation_px, 0.0);
  EXPECT_EQ(arc.duration_s, 0.0);
  EXPECT_EQ(arc.energy_drift_rel_max, 0.0);
  EXPECT_FALSE(arc.energy_drift_slope_per_s);  // No time passes.
}

TEST(ArcErrors, SayWhereXWasNotSolved) {
  Scenario scenario = open_sky({1.0, -900.0}, 60.0, 60);
  scenario.events = {{std::int64_t{20}, Stop{}}, {std::int64_t{40}, Fling{{0.0, 300.0}}}};
  Measured measured;
  measure(scenario, measured);
  ASSERT_EQ(measured.arcs.size(), 3u);
  EXPECT_TRUE(measured.arcs[0].solves_x);
  EXPECT_FALSE(measured.arcs[1].solves_x);
  EXPECT_EQ(measured.summary.arcs_without_x, 2);
}

TEST(DriftMeter, PassesEveryRowOfAnArcOnRequest) {
  Measured measured(true);
  measure(fling(), measured);
  std::size_t rows = 0;
  for (const ArcErrors& arc : measured.arcs) {
    ASSERT_EQ(measured.rows[rows].step, arc.first_step);
    EXPECT_EQ(measured.rows[rows].truncation_px, 0.0);
    double truncation_px = 0.0;
    for (std::int64_t step = arc.first_step; step <= arc.last_step; ++step, ++rows) {
      ASSERT_EQ(measured.rows[rows].step, step);
      truncation_px = std::max(truncation_px, measured.rows[rows].truncation_px);
    }
    EXPECT_DOUBLE_EQ(truncation_px, arc.truncation_px);
  }
  EXPECT_EQ(rows, measured.rows.size());
}

TEST(DriftMeter, HasNoErrorsForARunWithoutArcs) {
  Measured measured;
  measure(open_sky({0.0, 0.0}, 60.0, 1), measured);
  EXPECT_EQ(measured.summary.arcs, 0);
  EXPECT_FALSE(measured.summary.truncation_px);
  EXPECT_EQ(measured.summary.skipped_arcs, 1);
}

// Of a run that repeats itself a meter reads the beginning only, with the same summary.
TEST(DriftMeter, NeedsNoRowsOfPeriodsWithoutAnArc) {
  for (const double rate_hz : {60.0, 100.0, 240.0}) {
    Scenario scenario = open_sky({900.0, -900.0}, rate_hz, 130'000);
    scenario.window = {1920, 1080};
    scenario.start = {300.0, 500.0};
    Measured all;
    measure(scenario, all);
    Measured beginning;
    DriftMeter meter(scenario, inputs_of(scenario), beginning);
    MarginMeter margin(scenario, inputs_of(scenario));
    replay(shipped_core(), scenario, {&meter, &margin});
    EXPECT_EQ(meter.wants().rows_every, 0) << rate_hz;
    EXPECT_EQ(margin.wants().rows_every, 0) << rate_hz;
    const DriftSummary summary = meter.finish();
    EXPECT_EQ(summary.arcs, all.summary.arcs) << rate_hz;
    EXPECT_EQ(summary.contacts, all.summary.contacts) << rate_hz;
    EXPECT_EQ(summary.skipped_arcs, all.summary.skipped_arcs) << rate_hz;
    EXPECT_EQ(summary.truncation_px->value, all.summary.truncation_px->value) << rate_hz;
    MarginMeter of_all(scenario, inputs_of(scenario));
    of_all.rows(rows_of(scenario));
    EXPECT_EQ(margin.margin().half_width, of_all.margin().half_width) << rate_hz;
    EXPECT_EQ(margin.margin().nearest->step, of_all.margin().nearest->step) << rate_hz;
  }
}

}  // namespace
}  // namespace hyrax
