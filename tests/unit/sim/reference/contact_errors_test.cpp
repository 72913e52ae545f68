// The contact that ends an arc, against the true moment of impact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/result/estimate.h"
#include "tests/unit/sim/reference/test_run.h"
#include "tests/unit/sim/reference/wide.h"

namespace hyrax {
namespace {

constexpr double kGravity = 1200.0;
constexpr double kFloor_px = 1080.0 - 128.0;

// Falls straight down from a height, with no room for anything else.
Scenario fall(double height_px, double rate_hz) {
  Scenario scenario = fling();
  scenario.start = {500.0, kFloor_px - height_px};
  scenario.start_velocity = {0.0, 0.0};
  scenario.clock.base = FixedRate{rate_hz};
  scenario.length = static_cast<std::int64_t>(3.0 * rate_hz);
  return scenario;
}

ImpactErrors first_contact(const Scenario& scenario) {
  Measured measured;
  measure(scenario, measured);
  return measured.contacts.at(0);
}

// Where the matched ODE from rest has fallen `height_px`, by halving in 256 bits.
Wide true_time_s(double height_px, double rate_hz) {
  const Wide drag_rate = Wide(0.0) - log(Wide(0.999)) / Wide(1.0 / rate_hz);
  Wide low = 0.0;
  Wide high = 10.0;
  for (int i = 0; i < 120; ++i) {
    const Wide middle = (low + high) / 2.0;
    WideMotion motion;
    motion.fly(kGravity, drag_rate * middle, middle);
    (motion.displacement < Wide(height_px) ? low : high) = middle;
  }
  return low;
}

TEST(ContactErrors, UseTheTrueTimeOfImpact) {
  for (const double rate_hz : {24.0, 60.0, 144.0, 1000.0})
    for (const double height_px : {20.0, 321.0, 952.0}) {
      const Scenario scenario = fall(height_px, rate_hz);
      const ImpactErrors contact = first_contact(scenario);
      const Wide t = true_time_s(height_px, rate_hz);
      const double row_t_s = static_cast<double>(contact.step) / rate_hz;
      EXPECT_NEAR(row_t_s - contact.time_error_s.value(), t.rounded(), 1e-12 * t.rounded())
          << rate_hz << " Hz, " << height_px << " px";
    }
}

TEST(ContactErrors, OfSideWallsUseTheHorizontalSpeed) {
  Scenario scenario = fling();
  scenario.start = {1000.0, 300.0};
  scenario.start_velocity = {1500.0, -300.0};
  const ImpactErrors contact = first_contact(scenario);
  EXPECT_EQ(contact.wall, Wall::right);
  // v falls linearly with x under linear drag: v = v0 - k x; then one more factor of a frame or so.
  const double k = -std::log(0.999) * 60.0;
  EXPECT_NEAR(contact.effective_restitution.value(), 0.6, 0.6 * 0.002);
  const double t = -std::log1p(-k * 792.0 / 1500.0) / k;
  EXPECT_NEAR(static_cast<double>(contact.step) / 60.0 - contact.time_error_s.value(), t, 1e-12);
}

// The hitch's straight line goes far past the floor; the time of impact follows from the arc's own rate.
TEST(ContactErrors, CountALongFrameFromWhereTheFloorWasMet) {
  Scenario scenario = fall(321.0, 60.0);
  const std::int64_t clamped_step = first_contact(scenario).step;
  scenario.events.push_back({clamped_step - 1, Hitch{0.25}});
  const ImpactErrors contact = first_contact(scenario);
  const double row_t_s = static_cast<double>(clamped_step - 1) / 60.0 + 0.25;
  EXPECT_NEAR(row_t_s - contact.time_error_s.value(), true_time_s(321.0, 60.0).rounded(), 1e-12);
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

// Into the lower right corner; both walls clamp the same step, and the floor's friction acts on vx after
// the wall has turned it.
TEST(ContactErrors, OfACornerAreTwo) {
  const Scenario scenario = [] {
    Scenario corner = open_sky({0.0, 0.0}, 60.0, 3);
    corner.window = {1920, 1080};
    corner.start = {1792.0 - 15.0, kFloor_px - 15.0};
    corner.start_velocity = {500.0, 480.0};
    return corner;
  }();
  const Columns rows = rows_of(scenario);
  ASSERT_EQ(rows.contact[2], 2 | 8);
  Measured measured;
  measure(scenario, rows, measured);
  ASSERT_EQ(measured.contacts.size(), 2u);
  const ImpactErrors& right = measured.contacts[0];
  const ImpactErrors& ground = measured.contacts[1];
  EXPECT_EQ(right.wall, Wall::right);
  EXPECT_EQ(ground.wall, Wall::ground);
  EXPECT_EQ(right.step, ground.step);
  EXPECT_EQ(right.energy_jump_rel, ground.energy_jump_rel);
  EXPECT_NEAR(*right.effective_restitution, 0.6, 0.6 * 0.002);
  EXPECT_NEAR(*ground.effective_restitution, 0.6, 0.6 * 0.05);
}

// An arc of one step is skipped, the contact that ends it is not.
TEST(ContactErrors, AreListedOfAnArcOfOneStep) {
  Scenario scenario = open_sky({0.0, 600.0}, 60.0, 3);
  scenario.window = {1920, 1080};
  scenario.start = {100.0, kFloor_px - 15.0};
  Measured measured(true);
  measure(scenario, measured);
  ASSERT_EQ(measured.contacts.size(), 1u);
  EXPECT_EQ(measured.contacts[0].step, 2);
  EXPECT_EQ(measured.contacts[0].wall, Wall::ground);
  EXPECT_NEAR(2.0 / 60.0 - measured.contacts[0].time_error_s.value(), 15.0 / 610.0, 0.001);
  EXPECT_EQ(measured.summary.contacts, 1);
  EXPECT_EQ(measured.summary.arcs, 0);
  EXPECT_EQ(measured.summary.skipped_arcs, 2);
  EXPECT_TRUE(measured.rows.empty());
}

// The frames before the clamped one are long, the last is short: past it the short one's rate goes on.
TEST(ContactErrors, FlyEachFrameAtItsOwnRate) {
  Scenario scenario = fall(321.0, 60.0);
  scenario.clock.base = RecordedSteps{{0.1, 0.3, 0.2, 0.001, 0.2, 0.1, 0.1}};
  scenario.length = std::int64_t{7};
  const ImpactErrors contact = first_contact(scenario);
  ASSERT_EQ(contact.step, 5);
  WideMotion motion;
  const Wide drag = Wide(0.0) - log(Wide(0.999));
  for (const double dt_s : {0.1, 0.3, 0.2, 0.001}) motion.fly(kGravity, drag, dt_s);
  Wide low = 0.0;
  Wide high = 0.2;
  for (int i = 0; i < 120; ++i) {
    const Wide middle = (low + high) / 2.0;
    WideMotion end = motion;
    end.fly(kGravity, drag / 0.001 * middle, middle);
    (end.displacement < Wide(321.0) ? low : high) = middle;
  }
  EXPECT_NEAR(contact.time_error_s.value(), 0.2 - low.rounded(), 1e-13);
}

TEST(ContactErrors, SumUpRestitutionOverTheRun) {
  Measured measured;
  measure(fling(), measured);
  std::vector<double> values;
  for (const ImpactErrors& contact : measured.contacts)
    values.push_back(contact.effective_restitution.value());
  std::sort(values.begin(), values.end());
  const Spread& spread = measured.summary.effective_restitution;
  ASSERT_EQ(spread.count(), static_cast<std::int64_t>(measured.contacts.size()));
  EXPECT_EQ(spread.median(), quantile(values, 0.5));
  EXPECT_EQ(spread.smallest(), values.front());
  EXPECT_EQ(spread.largest(), values.back());
}

// As after a hitch of 8 h: its mean would be 2600.
TEST(Spread, OneValueFarOffDoesNotMoveTheMedian) {
  Spread spread;
  for (const double value : {0.6, 1.3e4, 0.5, 0.59, 0.61}) spread.add(value);
  EXPECT_EQ(spread.median(), 0.6);
  EXPECT_EQ(spread.smallest(), 0.5);
  EXPECT_EQ(spread.largest(), 1.3e4);
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

}  // namespace
}  // namespace hyrax
