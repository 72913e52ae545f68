#include "sim/reference/drift_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include "sim/core/shipped_core.h"
#include "sim/reference/arc_cutter.h"
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

double largest(std::initializer_list<double> differences) {
  LargestDistance distance;
  for (const double dx : differences) distance.add(dx, 0.0);
  return distance.value();
}

TEST(Largest, IsNanOnceOneIs) {
  EXPECT_EQ(larger(1.0, 2.0), 2.0);
  EXPECT_EQ(larger(2.0, 1.0), 2.0);
  EXPECT_EQ(largest({1.0, -3.0, 2.0}), 3.0);
  constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {larger(kNoNumber, 1.0), larger(1.0, kNoNumber), largest({kNoNumber, 1.0}),
                             largest({1.0, kNoNumber, 1e200, 0.0}), distance(0.0, kNoNumber)})
    EXPECT_TRUE(std::isnan(value));
}

TEST(LargestDistance, NeitherVanishesNorRunsOver) {
  EXPECT_DOUBLE_EQ(distance(3e-170, 4e-170), 5e-170 * 0.0);
  EXPECT_DOUBLE_EQ(distance(3e-150, 4e-150), 5e-150);
  EXPECT_DOUBLE_EQ(distance(3e200, 4e200), 5e200);
}

struct SeenArc {
  ArcStart start;
  std::int64_t last_step = 0;
  ArcEnd ended_by = ArcEnd::end;
  std::optional<std::int64_t> clamped_step;
};

struct Seen : ArcVisitor {
  void begin(const ArcStart& start) override { open = {start, start.row.step, ArcEnd::end, std::nullopt}; }
  void fly(const Row& row) override {
    EXPECT_EQ(row.step, open.last_step + 1);
    EXPECT_EQ(row.contact, 0);
    open.last_step = row.step;
  }
  void end(ArcEnd ended_by, const Row* clamped) override {
    open.ended_by = ended_by;
    if (clamped != nullptr) open.clamped_step = clamped->step;
    arcs.push_back(open);
  }
  void short_arc(const ArcStart& start, const Row* flown, const Row* clamped) override {
    ASSERT_TRUE(flown != nullptr || clamped != nullptr);
    const std::int64_t flown_steps = flown != nullptr ? 1 : 0;
    EXPECT_TRUE(flown == nullptr || flown->step == start.row.step + 1);
    EXPECT_TRUE(clamped == nullptr || clamped->step == start.row.step + flown_steps + 1);
  }
  SeenArc open;
  std::vector<SeenArc> arcs;
};

struct Cut {
  std::vector<SeenArc> arcs;
  std::int64_t skipped_arcs = 0;
  std::optional<std::int64_t> non_finite_step;
};

Cut cut(const Scenario& scenario, const Columns& rows) {
  Seen seen;
  ArcCutter cutter(scenario, inputs_of(scenario), seen);
  cutter.rows(rows);
  cutter.finish();
  return {seen.arcs, cutter.skipped_arcs(), cutter.non_finite_step()};
}

Cut cut(const Scenario& scenario) { return cut(scenario, rows_of(scenario)); }

// Flies, one event at frame 10, flies on.
Scenario interrupted_by(const Action& action) {
  Scenario scenario = open_sky({300.0, -500.0}, 60.0, 30);
  scenario.events.push_back({std::int64_t{10}, action});
  return scenario;
}

TEST(ArcCutter, NamesTheWallInXInACorner) {
  Columns rows = fly_by(paper_step(0.999), open_sky({300.0, -500.0}, 60.0, 5));
  rows.contact.back() = static_cast<std::uint8_t>(Wall::right) | static_cast<std::uint8_t>(Wall::ground);
  EXPECT_EQ(cut(open_sky({}, 60.0, 5), rows).arcs.at(0).ended_by, ArcEnd::right);
}

TEST(ArcCutter, BeginsAnArcAfterTheInputsOfTheNextFrame) {
  Scenario scenario = interrupted_by(Fling{{-100.0, -900.0}});
  scenario.events.push_back({std::int64_t{10}, Place{{7000.0, 8000.0}}});
  scenario.events.push_back({std::int64_t{10}, Hitch{0.5}});  // No input, but the last event.
  const Row start = cut(scenario).arcs.at(1).start.row;
  EXPECT_EQ(start.vx_px_per_s, -100.0);
  EXPECT_EQ(start.vy_px_per_s, -900.0);
  EXPECT_EQ(start.x_px, 7000.0);
  EXPECT_EQ(start.y_px, 8000.0);
}

TEST(ArcCutter, FollowsTheSizesInForce) {
  const Cut c = cut(interrupted_by(Resize{Size{900'000, 800'000}, std::nullopt}));
  ASSERT_EQ(c.arcs.size(), 2u);
  EXPECT_EQ(c.arcs[0].start.bounds.right_px, 1'000'000.0 - 128.0);
  EXPECT_EQ(c.arcs[1].start.bounds.right_px, 900'000.0 - 128.0);
  EXPECT_EQ(c.arcs[1].start.bounds.bottom_px, 800'000.0 - 128.0);
}

TEST(ArcCutter, ReportsAnInputOnTheRowBeforeAClamp) {
  Scenario scenario = fling();
  const std::int64_t clamped_step = cut(scenario).arcs.at(0).clamped_step.value();
  scenario.events.push_back({clamped_step - 1, Resize{Size{1921, 1080}, std::nullopt}});
  const Cut c = cut(scenario);
  EXPECT_EQ(c.arcs.at(0).ended_by, ArcEnd::input);
  EXPECT_EQ(c.skipped_arcs - cut(fling()).skipped_arcs, 1);  // The frame between the input and the clamp.
}

TEST(ArcCutter, SkipsArcsOfFewerThanTwoSteps) {
  const struct {
    std::int64_t steps;
    std::vector<std::int64_t> stops;
    std::size_t arcs;
    std::int64_t skipped_arcs;
  } cases[] = {{12, {1, 3, 11}, 2, 2},  // One step before the first stop, then two, and one after the last.
               {30, {0}, 1, 0},         // It is the start that is stopped.
               {0, {}, 0, 0}};
  for (const auto& [steps, stops, arcs, skipped_arcs] : cases) {
    Scenario scenario = open_sky({300.0, -500.0}, 60.0, steps);
    for (const std::int64_t frame : stops) scenario.events.push_back({frame, Stop{}});
    const Cut c = cut(scenario);
    ASSERT_EQ(c.arcs.size(), arcs) << steps;
    EXPECT_EQ(c.skipped_arcs, skipped_arcs) << steps;
    EXPECT_TRUE(arcs != 1 || c.arcs[0].start.row.vx_px_per_s == 0.0);
  }
}

TEST(ArcCutter, StopsBeforeARowThatIsNotFiniteOrThatNoScenarioHas) {
  for (const auto& [column, value] :
       {std::pair(&Columns::vy_px_per_s, std::numeric_limits<double>::quiet_NaN()),
        {&Columns::x_px, -2e100},
        {&Columns::dt_s, -1e-9},
        {&Columns::dt_s, 2e9}}) {
    Columns rows = fly_by(paper_step(0.999), open_sky({300.0, -500.0}, 60.0, 30));
    (rows.*column)[20] = value;
    const Cut c = cut(open_sky({}, 60.0, 30), rows);
    ASSERT_EQ(c.arcs.size(), 1u);
    EXPECT_EQ(c.arcs[0].last_step, 19);
    EXPECT_EQ(c.non_finite_step, 20);
  }
}

}  // namespace
}  // namespace hyrax
