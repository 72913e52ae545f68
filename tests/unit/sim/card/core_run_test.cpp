#include "sim/card/card.h"

#include <gtest/gtest.h>

#include "sim/core/contact_kernel.h"
#include "sim/core/listing_core.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

constexpr Constants kPaper{.gravity_px_per_s2 = 1200.0,
                           .restitution = 0.6,
                           .air_drag = 0.999,
                           .ground_friction = 0.8,
                           .rest_threshold_px_per_s = 5.0};

// Stands on the floor, where friction changes nothing, until it is flung.
Scenario flung_at(std::int64_t frame) {
  Scenario scenario = fling_at(60.0, kCoreRunRowsMax + 100'000, {{frame, Fling{{900.0, -500.0}}}});
  scenario.start_velocity = {};
  scenario.start = {300.0, bounds_of(scenario.window, scenario.sprite).bottom_px};
  return scenario;
}

Core core_with_friction(double ground_friction) {
  Constants constants = kPaper;
  constants.ground_friction = ground_friction;
  return listing_core(constants);
}

CoreRun run_with_friction(double ground_friction, const Scenario& scenario) {
  return play_by(core_with_friction(ground_friction), scenario);
}

bool settles_with_friction(double ground_friction, const Scenario& scenario) {
  const Core core = core_with_friction(ground_friction);
  return settles(core, scenario, play_by(core, scenario));
}

// With friction the fling settles after some seconds, without friction never.
TEST(CoreRun, ThatEndsBeforeItSettlesIsPlayedOn) {
  Scenario scenario = fling_at(60.0, 120);
  for (const bool is_recorded : {false, true}) {
    if (is_recorded) scenario.clock.base = RecordedSteps{std::vector(120, 1.0 / 60.0)};
    EXPECT_FALSE(run_with_friction(0.8, scenario).at_rest_since_s);
    EXPECT_TRUE(settles_with_friction(0.8, scenario)) << is_recorded;
    EXPECT_FALSE(settles_with_friction(1.0, scenario)) << is_recorded;
  }
  scenario.clock.base = FixedStep{0.0};
  EXPECT_FALSE(settles_with_friction(0.8, scenario));
}

TEST(CompareRuns, FindsADifferenceBeforeAndPastTheLastRowKept) {
  for (const bool is_cut : {false, true}) {
    const Scenario scenario = flung_at(kCoreRunRowsMax + (is_cut ? 50'000 : -50'000));
    const CoreRun run = run_with_friction(0.8, scenario);
    EXPECT_EQ(run.is_cut, is_cut);
    EXPECT_EQ(run.repetition.has_value(), !is_cut);
    EXPECT_EQ(std::ssize(run.rows) == kCoreRunRowsMax, is_cut);
    const auto changed_to = [&](CoreRun candidate) {
      CoreRun base = run;
      return compare_runs(scenario, base, candidate);
    };
    EXPECT_TRUE(changed_to(run).has_same_bits);
    const RunChange change = changed_to(run_with_friction(0.7, scenario));
    EXPECT_FALSE(change.has_same_bits) << is_cut;
    EXPECT_EQ(change.is_cut, is_cut);
    if (!is_cut) continue;
    const RunChange ended = changed_to(run_with_friction(1e300, scenario));
    EXPECT_TRUE(ended.became_non_finite);
    EXPECT_EQ(ended.difference, DifferenceClass::shape) << "though all rows that were kept are the same";
  }
}

TEST(CompareRuns, FindsNoStateThatBecameNonFiniteWhereThatOfTheBaseDidToo) {
  Constants unbounded = kPaper;
  unbounded.air_drag = 1e200;
  const Scenario scenario = fling_at(60.0, 5);
  const CoreRun run = play_by(listing_core(unbounded), scenario);
  for (CoreRun base : {run, run_with_friction(0.8, scenario)}) {
    CoreRun candidate = run;
    EXPECT_EQ(compare_runs(scenario, base, candidate).became_non_finite, base.is_finite);
  }
}

// Told by its rows alone, what stands at the left wall touches it in every step.
TEST(CompareRuns, FindsNoOtherBitsWhereContactsAloneAreOthers) {
  Scenario scenario = flung_at(kCoreRunRowsMax + 50'000);
  scenario.start.x_px = 0.0;
  Core by_rows = listing_core(kPaper);
  by_rows.kernel = std::make_shared<const ContactKernel>(by_rows.kernel, nullptr, std::nullopt);
  CoreRun base = play_by(listing_core(kPaper), scenario);
  CoreRun candidate = play_by(by_rows, scenario);
  const RunChange change = compare_runs(scenario, base, candidate);
  EXPECT_NE(change.contacts_before, change.contacts_after);
  EXPECT_TRUE(base.is_cut);
  EXPECT_TRUE(change.has_same_bits);
}

}  // namespace
}  // namespace hyrax
