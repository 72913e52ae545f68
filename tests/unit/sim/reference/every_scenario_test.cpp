// Every scenario, including the hard ones and those far from the origin, and random ones against the
// reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "sim/core/shipped_core.h"
#include "sim/reference/gsl_flight.h"
#include "tests/unit/sim/reference/test_run.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

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
  GslFlight gsl;
  DriftMeter meter(scenario, inputs_of(scenario), run, &gsl);
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

INSTANTIATE_TEST_SUITE_P(Scenarios, EveryScenario, testing::ValuesIn(scenario_files()), [](const auto& test) {
  std::string name = std::filesystem::path(test.param).stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace hyrax
