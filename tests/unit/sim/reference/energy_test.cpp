// The energy of a run against the reference's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/core/shipped_core.h"
#include "sim/reference/energy_causes.h"
#include "tests/unit/sim/reference/test_run.h"

namespace hyrax {
namespace {

constexpr double kGravity = 1200.0;
constexpr double kRate_hz = 60.0;
constexpr double kFall_px2_per_s3 = kGravity * kGravity / kRate_hz / 2.0;  // G^2 h / 2.

// A fling of five seconds in frames of 1e-4 to 5 s.
class LongFrames : public testing::TestWithParam<double> {
 protected:
  static Scenario scenario() {
    Scenario scenario = fling();
    scenario.clock.base = FixedStep{GetParam()};
    scenario.length = static_cast<std::int64_t>(std::max(2.0, 5.0 / GetParam()));
    return scenario;
  }
};

TEST_P(LongFrames, ListAllContacts) {
  TraceSink log;
  replay(shipped_core(), scenario(), log);
  Measured measured;
  measure(scenario(), measured);
  ASSERT_EQ(measured.contacts.size(), log.contacts().size());
  for (std::size_t at = 0; at < log.contacts().size(); ++at) {
    const ImpactErrors& listed = measured.contacts[at];
    const Contact& contact = log.contacts()[at];
    EXPECT_EQ(listed.step, contact.step);
    EXPECT_EQ(listed.wall, contact.wall);
    EXPECT_NEAR(listed.overshoot_px, contact.overshoot_px, 1e-14 * contact.overshoot_px + 1e-12);
  }
  EXPECT_TRUE(log.contacts().size() >= 2 || GetParam() < 1e-3) << "drag once a frame lets it sink";
  EXPECT_EQ(measured.summary.reference_faults, 0);
}

TEST_P(LongFrames, AddUpToTheEnergyChangeOfTheRun) {
  const Columns rows = rows_of(scenario());
  Measured measured;
  measure(scenario(), rows, measured);
  const DriftSummary& s = measured.summary;
  const ContactEnergyParts& c = s.contact_energy;
  const auto energy_on_desktop = [](const Row& row) {
    return (row.vx_px_per_s * row.vx_px_per_s + row.vy_px_per_s * row.vy_px_per_s) / 2 +
           kGravity * (952.0 - row.y_px);
  };
  double largest = 0.0;
  for (std::size_t row = 0; row < rows.size(); ++row)
    largest = std::max(largest, energy_on_desktop(rows.row(row)));
  for (const ImpactErrors& contact : measured.contacts)
    largest = std::max(largest, std::fabs(contact.energy_parts.lift));
  const double change = energy_on_desktop(rows.row(rows.size() - 1)) - energy_on_desktop(rows.row(0));
  EXPECT_NEAR(s.reference_energy_px2_per_s2 + s.arc_energy.gravity + s.arc_energy.drag + c.flight + c.lift +
                  c.bounce + c.friction + c.rest + s.unlisted_energy_px2_per_s2,
              change, 1e-9 + 1e-12 * largest);
}

INSTANTIATE_TEST_SUITE_P(OfAFling, LongFrames,
                         testing::Values(1e-4, 1e-3, 1.0 / 60.0, 0.1, 0.5, 1.0, 2.0, 5.0));

// Below the floor by more than its speed can lift it: no energy that a drift could be measured by.
TEST(EnergyDrift, IsRelativeToAPixelOfHeightAtLeast) {
  Scenario scenario = open_sky({0.0, 0.0}, kRate_hz, 30);
  scenario.start = {0.0, 2'000'000.0};
  Measured measured;
  measure(scenario, fly_by(paper_step(0.999), scenario), measured);
  const ArcErrors& arc = measured.arcs.at(0);
  EXPECT_LT(arc.energy_largest_px2_per_s2, 0.0);
  EXPECT_NEAR(arc.energy_drift_end_px2_per_s2, -kFall_px2_per_s3 * 0.5, 0.05 * kFall_px2_per_s3);
  EXPECT_EQ(arc.energy_drift_rel_end, arc.energy_drift_end_px2_per_s2 / 1200.0);
  EXPECT_EQ(arc.energy_drift_rel_max, arc.energy_drift_max_px2_per_s2 / 1200.0);

  Measured of_moon;
  measure(scenario, fly_by(paper_step(0.999), scenario), of_moon, nullptr, {.gravity_px_per_s2 = 200.0});
  const ArcErrors& slow = of_moon.arcs.at(0);
  EXPECT_EQ(slow.energy_drift_rel_end, slow.energy_drift_end_px2_per_s2 / 200.0);
}

TEST(EnergyDrift, IsZeroWhereThereIsNoEnergy) {
  const Scenario scenario = open_sky({0.0, 0.0}, kRate_hz, 30);
  const Model weightless{.gravity_px_per_s2 = 0.0};
  Measured measured;
  measure(scenario, fly_by(paper_step(0.999, 0.0), scenario), measured, nullptr, weightless);
  EXPECT_EQ(measured.arcs.at(0).energy_drift_rel_max, 0.0);
  EXPECT_FALSE(measured.arcs.at(0).energy_drift_slope_px_per_s) << "without gravity there is no height";
  EXPECT_FALSE(measured.summary.secular_px_per_s);
}

TEST(EnergyCauseSum, CountsTheLiftOutOfACornerOnceAndNoBounceWithoutATimeOfImpact) {
  EnergyCauseSum causes(kGravity);
  ImpactErrors contact;
  contact.step = 7;
  contact.energy_parts = {.lift = 120.0};
  contact.late_bounce_px2_per_s2 = 600.0;
  for (const Wall wall : {Wall::left, Wall::ground}) {
    contact.wall = wall;
    causes.add(contact);
  }
  EXPECT_DOUBLE_EQ(causes.now().lift, 0.1);
  EXPECT_DOUBLE_EQ(causes.now().bounce, 1.0);
  contact.step = 8;
  contact.late_bounce_px2_per_s2.reset();
  causes.add(contact);
  EXPECT_DOUBLE_EQ(causes.now().lift, 0.2);
  EXPECT_DOUBLE_EQ(causes.now().bounce, 1.0);
}

}  // namespace
}  // namespace hyrax
