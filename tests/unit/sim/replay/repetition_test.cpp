// A run that skips what repeats exactly is the run that computes it all.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "sim/core/contact_stepper.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/core/stepper_of.h"
#include "sim/replay/replay.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

RunSummary play(const Scenario& scenario, TraceSink& trace, bool skips_repetition,
                const Core& core = shipped_core()) {
  return replay(core, scenario, trace, {.skips_repetition = skips_repetition, .checks_bounds = true});
}

// Plays with and without skipping, expects equal results, and returns those with skipping.
RunSummary expect_skipping_changes_nothing(const Scenario& scenario, std::int64_t rows_every,
                                           const std::string& which, const Core& core = shipped_core()) {
  const RowSink::Wants wants{.rows_every = rows_every, .contacts = true, .blocks = true};
  TraceSink skipping(wants);
  TraceSink computing(wants);
  const RunSummary a = play(scenario, skipping, true, core);
  const RunSummary b = play(scenario, computing, false, core);
  EXPECT_TRUE(same_trace(skipping, computing)) << which;
  EXPECT_EQ(b.steps_computed, b.steps) << which;
  RunSummary expected = b;
  expected.steps_computed = a.steps_computed;
  EXPECT_EQ(text_of(a), text_of(expected)) << which;
  return a;
}

TEST(SkippedRepetition, ChangesNothingInRandomFlings) {
  std::set<std::int64_t> periods;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const std::int64_t rows_every = std::array{0, 1, 7, 4096}[seed % 4];
    const RunSummary summary =
        expect_skipping_changes_nothing(any_fling(seed, 12'000), rows_every, "seed " + std::to_string(seed));
    if (summary.periodic_from_step) periods.insert(summary.period_steps);
  }
  // Residual speed and zero speed have period 1, the two-cycle and a sprite wider than its window have 2.
  EXPECT_EQ(periods, (std::set<std::int64_t>{1, 2}));
}

TEST(SkippedRepetition, MayEndAtAnyStepOfAPeriod) {
  // The rest of this fling repeats with a period of two steps.
  for (std::int64_t steps = 6000; steps < 6010; ++steps) {
    const RunSummary summary =
        expect_skipping_changes_nothing(fling_at(120.0, steps), 1, std::to_string(steps) + " steps");
    // One period to notice it, and one that is repeated.
    EXPECT_EQ(summary.steps_computed, *summary.periodic_from_step + 2 * summary.period_steps);
  }
}

// Moves with the velocity before gravity, so that it never rests.
struct EulerStep {
  void operator()(State& s, double dt_s, const Bounds& bounds) const {
    s.y_px += s.vy_px_per_s * dt_s;
    s.vy_px_per_s = (s.vy_px_per_s + 1200.0 * dt_s) * 0.999;
    if (s.y_px <= bounds.bottom_px) return;
    s.y_px = bounds.bottom_px;
    s.vy_px_per_s *= -0.6;
  }
};

TEST(SkippedRepetition, HasBlocksThatDifferWhereItsPeriodDoesNotDivideThem) {
  const Core euler{.stepper = std::make_shared<const ContactStepper>(
                       std::make_shared<const StepperOf<StepCores<EulerStep>>>(), nullptr, std::nullopt)};
  for (const std::int64_t steps : {20'479, 20'480, 20'481, 50'000}) {
    const RunSummary summary =
        expect_skipping_changes_nothing(fling_at(60.0, steps), 1, std::to_string(steps) + " steps", euler);
    EXPECT_EQ(summary.period_steps, 6);
    EXPECT_GT(summary.contacts.ground, 1000);
    EXPECT_LT(summary.steps_computed, 10'000);
  }
}

TEST(SkippedRepetition, ContinuesAfterALaterInput) {
  for (const std::int64_t frame : {8191, 8192, 8193, 9000, 9001}) {
    const Scenario scenario =
        fling_at(60.0, 20'000, {{frame, Resize{Size{800, 600}, {}}}, {frame + 4000, Fling{{500.0, -800.0}}}});
    const RunSummary summary =
        expect_skipping_changes_nothing(scenario, 1, "input at " + std::to_string(frame));
    EXPECT_LT(summary.steps_computed, summary.steps);
  }
}

TEST(SkippedRepetition, CoversWhatIsHeldWithoutTimeOrKnocksForever) {
  const Scenario held =
      fling_at(60.0, 50'000, {{std::int64_t{10}, Grab{}}, {std::int64_t{40'000}, Release{{900.0, -1200.0}}}});
  EXPECT_LT(expect_skipping_changes_nothing(held, 1, "held").steps_computed, 15'000);
  Scenario without_time = fling_at(60.0, 100'000);
  without_time.clock.base = FixedStep{0.0};
  without_time.start_velocity = {};
  EXPECT_EQ(expect_skipping_changes_nothing(without_time, 97, "dt of 0").periodic_from_step, 0);
  // A sprite wider than its window touches both walls in turn: more contacts than are recorded.
  Scenario knocking = fling_at(60.0, kContactsRecordedMax + 20'000);
  knocking.window = {100, 1080};
  const WallCounts contacts = expect_skipping_changes_nothing(knocking, 0, "knocking").contacts;
  EXPECT_GT(contacts.left + contacts.right, kContactsRecordedMax);
}

TEST(SkippedRepetition, IsPeriodicFromTheRowItNames) {
  constexpr std::int64_t at = 20;
  Scenario without_time = fling_at(60.0, 3'000, {{at, Stop{}}});
  without_time.clock.base = FixedStep{0.0};
  const Scenario held = fling_at(60.0, 3'000, {{at, Grab{}}});
  const Scenario placed = fling_at(60.0, 3'000, {{at - 5, Grab{}}, {at, Place{{5.0, 6.0}}}});
  for (const auto& [scenario, from_step] : {std::pair{fling_at(60.0, 30'000), std::optional<std::int64_t>()},
                                            {without_time, at + 1},
                                            {held, at + 1},
                                            {placed, at + 1}}) {
    TraceSink trace;
    const RunSummary summary = play(scenario, trace, false);
    ASSERT_TRUE(summary.periodic_from_step);
    if (from_step) {
      EXPECT_EQ(summary.periodic_from_step, from_step);
    }
    ASSERT_GT(summary.period_steps, 0);
    const auto state_at = [&](std::int64_t step) {
      return state_of(trace.rows()[static_cast<std::size_t>(step)]);
    };
    for (std::int64_t step = *summary.periodic_from_step; step + summary.period_steps <= summary.steps;
         ++step)
      ASSERT_TRUE(same_bits(state_at(step), state_at(step + summary.period_steps))) << step;
  }
}

TEST(SkippedRepetition, PlaysTheLongestRunInAMoment) {
  TraceSink trace(RowSink::Wants{.rows_every = 1'000'000'000});
  const RunSummary summary = play(fling_at(60.0, 100'000'000'000), trace, true);
  EXPECT_EQ(summary.steps, 100'000'000'000);
  EXPECT_LT(summary.steps_computed, 100'000);
  EXPECT_EQ(trace.rows().size(), 101u);
}

}  // namespace
}  // namespace hyrax
