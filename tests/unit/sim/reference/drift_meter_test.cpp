#include "sim/reference/drift_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "sim/core/shipped_core.h"
#include "sim/reference/largest.h"
#include "sim/reference/margin.h"
#include "tests/unit/sim/reference/test_run.h"

namespace hyrax {
namespace {

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

TEST(ContactErrors, HaveNoTimeWhereTheWallIsNotMetInTwoFrames) {
  // A contact byte that claims the floor where neither the run nor the ODE is near it.
  const Scenario scenario = open_sky({0.0, -500.0}, 60.0, 30);
  Columns rows = fly_by(paper_step(0.999), scenario);
  rows.contact.back() = static_cast<std::uint8_t>(Wall::ground);
  Measured measured;
  measure(scenario, rows, measured);
  EXPECT_FALSE(measured.contacts.at(0).time_error_s);
  EXPECT_FALSE(measured.contacts.at(0).effective_restitution);
}

TEST(Spread, OfVeryManyValuesKeepsEveryKthForTheMedian) {
  const auto count = static_cast<std::int64_t>(5 * Spread::kKeptMax + 7);
  for (const std::int64_t stride :
       {7919, 1}) {  // In no order, and rising, where later ones must not weigh more.
    Spread spread;
    for (std::int64_t i = 0; i < count; ++i) spread.add(static_cast<double>(i * stride % count));
    EXPECT_EQ(spread.count(), count);
    EXPECT_NEAR(spread.median(), 0.5 * static_cast<double>(count), 0.01 * static_cast<double>(count))
        << stride;
    EXPECT_EQ(spread.largest(), static_cast<double>(count - 1));
  }
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

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double largest(std::initializer_list<double> differences) {
  LargestDistance distance;
  for (const double dx : differences) distance.add(dx, 0.0);
  return distance.value();
}

TEST(Largest, IsNanOnceOneIs) {
  EXPECT_EQ(larger(1.0, 2.0), 2.0);
  EXPECT_EQ(larger(2.0, 1.0), 2.0);
  EXPECT_EQ(largest({1.0, -3.0, 2.0}), 3.0);
  for (const double value : {larger(kNaN, 1.0), larger(1.0, kNaN), largest({kNaN, 1.0}),
                             largest({1.0, kNaN, 1e200, 0.0}), distance(0.0, kNaN)})
    EXPECT_TRUE(std::isnan(value));
}

TEST(LargestDistance, NeitherVanishesNorRunsOver) {
  EXPECT_DOUBLE_EQ(distance(3e-170, 4e-170), 5e-170 * 0.0);
  EXPECT_DOUBLE_EQ(distance(3e-150, 4e-150), 5e-150);
  EXPECT_DOUBLE_EQ(distance(3e200, 4e200), 5e200);
}

}  // namespace
}  // namespace hyrax
