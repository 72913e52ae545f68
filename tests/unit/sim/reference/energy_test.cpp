// Every scenario, including the hard ones and those far from the origin, random ones, and flings in long
// frames against the reference: their motion and their energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/reference/drift.h"
#include "sim/reference/gsl_flight.h"
#include "tests/unit/sim/reference/test_run.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

constexpr double kGravity_px_per_s2 = 1200.0;
constexpr double kRate_hz = 60.0;
constexpr double kFall_px2_per_s3 = kGravity_px_per_s2 * kGravity_px_per_s2 / kRate_hz / 2.0;  // G^2 h / 2.

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

TEST_P(LongFrames, AddUpToTheEnergyChangeOfTheRun) {
  const Columns rows = rows_of(scenario());
  Measured measured;
  measure(scenario(), rows, measured);
  const DriftSummary& s = measured.summary;
  EXPECT_EQ(s.reference_faults, 0);
  double parts = 0.0;
  for (const ArcErrors& arc : measured.arcs) parts += arc.energy_parts.gravity + arc.energy_parts.drag;
  for (const ImpactErrors& contact : measured.contacts) {
    const ContactEnergyParts& c = contact.energy_parts;
    if (!contact.is_second_of_corner) parts += c.flight + c.lift + c.bounce + c.friction + c.rest;
  }
  const auto energy_on_desktop = [](const Row& row) {
    return (row.vx_px_per_s * row.vx_px_per_s + row.vy_px_per_s * row.vy_px_per_s) / 2 +
           kGravity_px_per_s2 * (952.0 - row.y_px);
  };
  double largest = 0.0;
  for (std::size_t row = 0; row < rows.size(); ++row)
    largest = std::max(largest, energy_on_desktop(rows.row(row)));
  for (const ImpactErrors& contact : measured.contacts)
    largest = std::max(largest, std::fabs(contact.energy_parts.lift));
  const double change = energy_on_desktop(rows.row(rows.size() - 1)) - energy_on_desktop(rows.row(0));
  EXPECT_NEAR(s.reference_energy_px2_per_s2 + parts + s.unlisted_energy_px2_per_s2, change,
              1e-9 + 1e-12 * largest);
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
  Model moon;
  moon.gravity_px_per_s2 = 200.0;
  measure(scenario, fly_by(paper_step(0.999), scenario), of_moon, nullptr, moon);
  const ArcErrors& slow = of_moon.arcs.at(0);
  EXPECT_EQ(slow.energy_drift_rel_end, slow.energy_drift_end_px2_per_s2 / 200.0);
}

TEST(EnergyDrift, IsZeroWhereThereIsNoEnergy) {
  const Scenario scenario = open_sky({0.0, 0.0}, kRate_hz, 30);
  Model weightless;
  weightless.gravity_px_per_s2 = 0.0;
  Measured measured;
  measure(scenario, fly_by(paper_step(0.999, 0.0), scenario), measured, nullptr, weightless);
  EXPECT_EQ(measured.arcs.at(0).energy_drift_rel_max, 0.0);
  EXPECT_FALSE(measured.arcs.at(0).energy_drift_slope_px_per_s) << "without gravity there is no height";
  EXPECT_FALSE(measured.summary.secular_px_per_s);
}

TEST(EnergyCauseSum, CountsTheLiftOutOfACornerOnceAndNoBounceWithoutATimeOfImpact) {
  EnergyCauseSum causes(kGravity_px_per_s2);
  ImpactErrors contact;
  contact.energy_parts = {.lift = 120.0};
  contact.flight_error_px2_per_s2 = -12.0;
  contact.bounce_error_px2_per_s2 = 600.0;
  causes.add(contact);
  contact.is_second_of_corner = true;
  causes.add(contact);
  EXPECT_DOUBLE_EQ(causes.now().lift, 0.1);
  EXPECT_DOUBLE_EQ(causes.now().flight, -0.01);
  EXPECT_DOUBLE_EQ(causes.now().bounce, 1.0);
  contact.is_second_of_corner = false;
  contact.bounce_error_px2_per_s2.reset();
  causes.add(contact);
  EXPECT_DOUBLE_EQ(causes.now().lift, 0.2);
  EXPECT_DOUBLE_EQ(causes.now().bounce, 1.0);
}

// With exact flights between exact bounces, of the first bounce of a drop without drag: what the run has
// after it less than the exact drop is what its causes add up to. After a bounce 0.36 of what came before is
// left.
TEST(EnergyCauses, OfADropAddUpToWhatItHasLostAfterItsBounce) {
  Model model;
  model.air_drag = 1.0;
  Scenario scenario = fling_at(kRate_hz, 200);
  scenario.start = {500.0, 300.0};
  scenario.start_velocity = {};
  Columns rows;
  Measured measured;
  const Core core = listing_core(model);
  TraceSink trace({.rows_every = 1});
  replay(core, scenario, trace);
  for (const Row& row : trace.rows()) {
    rows.append(row);
    if (row.contact != 0) break;
  }
  scenario.length = static_cast<std::int64_t>(rows.size()) - 1;
  measure(scenario, rows, measured, nullptr, model);
  const Row after = rows.row(rows.size() - 1);
  const double lost_px =
      after.vy_px_per_s * after.vy_px_per_s / 2.0 / kGravity_px_per_s2 - 0.36 * (952.0 - 300.0);
  const EnergyCauses& causes = measured.summary.causes;
  EXPECT_NEAR(causes.sum() + causes.flight, lost_px, 1e-9);
  EXPECT_NEAR(causes.flight, -kFall_px2_per_s3 / kRate_hz / kGravity_px_per_s2, 1e-9) << "a frame of gravity";
  EXPECT_GT(causes.lift, 0.0);
}

// Speeds are at most the root of twice the energy.
double speed_rounding_px_per_s(const ArcErrors& arc) {
  return 1e-8 + 1e-12 * std::sqrt(2.0 * arc.energy_largest_px2_per_s2);
}

// The discrete closed form and the exact law of the step.
void expect_followed(const ArcErrors& arc) {
  SCOPED_TRACE(arc.first_step);
  const double rounding_px = 1e-8 + 1e-12 * arc.coordinate_largest_px;
  EXPECT_LT(arc.implementation_px, rounding_px);
  EXPECT_LT(arc.implementation_px_per_s, speed_rounding_px_per_s(arc));
  EXPECT_LT(arc.exact_law_px, rounding_px);
  EXPECT_LT(arc.exact_law_px_per_s, speed_rounding_px_per_s(arc));
}

// The parts of an energy are the model's own operations, the sum is that of the run's rows.
void expect_followed_with_energy_parts_that_add_up(const Scenario& scenario) {
  Measured run;  // Live, so that ten million rows are never held.
  const std::unique_ptr<FlightSolver> gsl = gsl_flight();
  DriftMeter meter(scenario, inputs_of(scenario), run, gsl.get());
  replay(shipped_core(), scenario, meter);
  run.summary = meter.finish();
  EXPECT_EQ(run.summary.reference_faults, 0);
  EXPECT_EQ(run.summary.differing_steps, 0);
  for (const ArcErrors& arc : run.arcs) {
    expect_followed(arc);
    EXPECT_NEAR(arc.energy_parts.gravity + arc.energy_parts.drag, arc.energy_drift_end_px2_per_s2,
                1e-9 + 1e-12 * arc.energy_scale_px2_per_s2);
  }
  for (const ImpactErrors& contact : run.contacts) {
    const ContactEnergyParts& e = contact.energy_parts;
    const double largest = std::max({std::fabs(e.flight), std::fabs(e.lift), std::fabs(e.bounce),
                                     std::fabs(e.friction), std::fabs(e.rest)});
    EXPECT_NEAR(e.flight + e.lift + e.bounce + e.friction + e.rest, contact.energy_jump_px2_per_s2,
                1e-9 + 1e-12 * largest)
        << contact.step;
  }
}

TEST(RandomRuns, FollowTheirReferencesAndHaveEnergyPartsThatAddUp) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Scenario scenario = any_fling(seed, 1000);
    const double dt_s = base_dt_s(scenario.clock);
    if (seed % 4 == 1) scenario.clock.jitter = Jitter{Jitter::Kind::uniform, 1.0, seed};
    if (seed % 4 == 2) scenario.clock.jitter = Jitter{Jitter::Kind::normal, dt_s, seed};  // Many of length 0.
    if (seed % 4 == 3) scenario.clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.3, seed};
    expect_followed_with_energy_parts_that_add_up(scenario);
  }
}

class EveryScenario : public testing::TestWithParam<std::string> {};

TEST_P(EveryScenario, FollowsItsReferencesAndHasEnergyPartsThatAddUp) {
  expect_followed_with_energy_parts_that_add_up(load_scenario(GetParam()));
}

// A million frames take longer than all scenarios of fewer.
std::vector<std::string> scenario_files_of(bool is_long) {
  std::vector<std::string> files = scenario_files();
  std::erase_if(
      files, [=](const std::string& file) { return file.ends_with("/frames-past-a-float.json") != is_long; });
  return files;
}

std::string name_of(const testing::TestParamInfo<std::string>& test) {
  std::string name = std::filesystem::path(test.param).stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scenarios, EveryScenario, testing::ValuesIn(scenario_files_of(false)), name_of);
INSTANTIATE_TEST_SUITE_P(DISABLED_Long, EveryScenario, testing::ValuesIn(scenario_files_of(true)), name_of);

}  // namespace
}  // namespace hyrax
