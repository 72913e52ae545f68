// The replay against the frame rule played plainly, and the run's ends.
#include "sim/replay/replay.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include "tests/unit/sim/replay/plain_replay.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

void expect_plain_run(const Scenario& scenario, const std::string& which) {
  const PlainRun plain = PlainReplay(scenario).play();
  TraceSink trace;
  const RunSummary summary =
      replay(shipped_core(), scenario, trace, {.skips_repetition = true, .checks_bounds = true});
  EXPECT_TRUE(same_rows(trace.rows(), plain.rows)) << which;
  EXPECT_TRUE(same_contacts(trace.contacts(), plain.contacts)) << which;
  EXPECT_EQ(hex(summary.state_hash), plain.state_hash()) << which;
  EXPECT_EQ(summary.steps, step_count(scenario)) << which;
  EXPECT_TRUE(same_row(summary.final, plain.rows.back())) << which;
  EXPECT_TRUE(same_bits(summary.simulated_s, plain.rows.back().t_s)) << which;
  EXPECT_EQ(summary.at_rest_since_s, plain.at_rest_since_s()) << which;
  EXPECT_EQ(summary.out_of_bounds_step, plain.out_of_bounds_step) << which;
  EXPECT_EQ(summary.rest_steps, plain.steps_with(kRestBit)) << which;
  WallCounts contacts{};
  for (const Contact& contact : plain.contacts) ++contacts[contact.wall];
  EXPECT_EQ(summary.contacts, contacts) << which;
  for (const Wall wall : kWalls)
    EXPECT_EQ(summary.clamped_steps[wall], plain.steps_with(static_cast<std::uint8_t>(wall))) << which;
}

TEST(Replay, PlaysEveryKindOfInputByTheFrameRule) { expect_plain_run(eventful_fling(), "eventful"); }

TEST(Replay, PlaysRandomFlingsByTheFrameRule) {
  for (std::uint64_t seed = 0; seed < 300; ++seed)
    expect_plain_run(any_fling(seed, 1000), "seed " + std::to_string(seed));
}

TEST(Replay, RecordsEveryFewRowsAndTheLastOne) {
  TraceSink trace(RowSink::Wants{.rows_every = 4});
  replay(shipped_core(), fling_at(60.0, 10), trace);
  std::vector<std::int64_t> steps;
  for (const Row& row : trace.rows()) steps.push_back(row.step);
  EXPECT_EQ(steps, (std::vector<std::int64_t>{0, 4, 8, 10}));
  EXPECT_TRUE(trace.contacts().empty());
  EXPECT_TRUE(trace.blocks().empty());
}

TEST(Replay, EndsWhereAFramesDtOverflowsTheSpeed) {
  Scenario scenario = fling_at(60.0, 9000, {{std::int64_t{5000}, Hitch{1e306}}});
  TraceSink skipping;
  TraceSink computing;
  const RunSummary summary = replay(shipped_core(), scenario, skipping);
  EXPECT_EQ(summary.non_finite_step, 5001);
  EXPECT_EQ(summary.steps, 5001);
  EXPECT_EQ(summary.final.step, 5001);
  ASSERT_EQ(skipping.rows().size(), 5002u);
  EXPECT_TRUE(is_finite(state_of(skipping.rows()[5000])));
  EXPECT_FALSE(is_finite(state_of(skipping.rows()[5001])));
  EXPECT_EQ(replay(shipped_core(), scenario, computing, {.skips_repetition = false}).state_hash,
            summary.state_hash);
  EXPECT_TRUE(same_trace(skipping, computing));
}

TEST(Replay, ReportsWhatTheRunExercised) {
  TraceSink trace;
  const RunSummary slides = replay(shipped_core(), fling_at(60.0, 600), trace);
  EXPECT_TRUE(slides.had_gravity && slides.had_drag && slides.had_friction);

  Scenario weightless = fling_at(60.0, 10);
  weightless.clock.base = FixedStep{0.0};
  const RunSummary damped = replay(shipped_core(), weightless, trace);
  EXPECT_TRUE(damped.had_drag);
  EXPECT_FALSE(damped.had_gravity || damped.had_friction);

  Scenario drop = fling_at(60.0, 600);
  drop.start_velocity = {};
  EXPECT_FALSE(replay(shipped_core(), drop, trace).had_friction);
  EXPECT_FALSE(replay(shipped_core(), fling_at(60.0, 10, {{std::int64_t{0}, Grab{}}}), trace).had_drag);
}

}  // namespace
}  // namespace hyrax
