// A run that is cut, stopped and resumed comes to the same bits.
#include <gtest/gtest.h>

#include "sim/replay/replay.h"
#include "tests/sim/replay/some_flings.h"
#include "tests/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

struct Played {
  explicit Played(const Scenario& scenario) { summary = replay(scenario, trace); }
  TraceSink trace;
  RunSummary summary;
};

Keyframe stop_at(const Scenario& scenario, std::int64_t step) {
  TraceSink trace;
  Replay run(scenario, trace);
  run.play_to(step);
  return run.keyframe();
}

std::vector<Row> rows_after(const std::vector<Row>& rows, std::int64_t step) {
  std::vector<Row> after;
  for (const Row& row : rows)
    if (row.step > step) after.push_back(row);
  return after;
}

std::vector<Contact> contacts_after(const std::vector<Contact>& contacts, std::int64_t step) {
  std::vector<Contact> after;
  for (const Contact& contact : contacts)
    if (contact.step > step) after.push_back(contact);
  return after;
}

void expect_resumable_everywhere(const Scenario& scenario) {
  const Played whole(scenario);
  for (std::int64_t step = 0; step <= whole.summary.steps; ++step) {
    const Keyframe keyframe = stop_at(scenario, step);
    ASSERT_TRUE(same_row(keyframe.row, whole.trace.rows()[static_cast<std::size_t>(step)]));
    TraceSink trace;
    Replay resumed(scenario, keyframe, trace);
    resumed.play_to(resumed.steps());
    const RunSummary summary = resumed.finish();
    ASSERT_TRUE(same_rows(trace.rows(), rows_after(whole.trace.rows(), step))) << "from " << step;
    ASSERT_TRUE(same_contacts(trace.contacts(), contacts_after(whole.trace.contacts(), step)))
        << "from " << step;
    ASSERT_TRUE(same_row(summary.final, whole.summary.final)) << "from " << step;
  }
}

TEST(ResumedReplay, GoesOnToTheSameBitsFromEveryRow) { expect_resumable_everywhere(eventful_fling()); }

TEST(ResumedReplay, GoesOnFromARestThatRepeats) { expect_resumable_everywhere(fling_at(240.0, 1500)); }

TEST(ResumedReplay, GoesOnFromARecordedTrace) {
  Scenario scenario = fling_at(60.0, 0);
  RecordedSteps trace;
  for (int frame = 0; frame < 200; ++frame) trace.dt_s.push_back(frame % 7 == 0 ? 0.0333 : 0.0167);
  scenario.clock.base = trace;
  scenario.length = {};
  expect_resumable_everywhere(scenario);
}

TEST(ResumedReplay, RecordsTheRowsThatAWholeRunRecords) {
  const Scenario scenario = fling_at(60.0, 100);
  for (const std::int64_t every : {1, 3, 10, 64, 1000})
    for (const std::int64_t step : {0, 1, 29, 30, 99}) {
      TraceSink whole(RowSink::Wants{.rows_every = every});
      replay(scenario, whole);
      TraceSink trace(RowSink::Wants{.rows_every = every});
      Replay resumed(scenario, stop_at(scenario, step), trace);
      resumed.play_to(resumed.steps());
      resumed.finish();
      EXPECT_TRUE(same_rows(trace.rows(), rows_after(whole.rows(), step))) << every << " from " << step;
    }
}

TEST(ResumedReplay, MakesEveryBlockAgainFromItsKeyframe) {
  Scenario scenario = fling_at(60.0, 20'000, {{std::int64_t{9000}, Fling{{300.0, -900.0}}}});
  scenario.clock.jitter = Jitter{Jitter::Kind::normal, 0.001, 3};
  const Played whole(scenario);
  ASSERT_EQ(whole.trace.keyframes().size(), 5u);
  for (std::size_t block = 0; block < whole.trace.keyframes().size(); ++block) {
    TraceSink trace;
    Replay resumed(scenario, whole.trace.keyframes()[block], trace);
    const std::int64_t last_step = whole.trace.blocks()[block].first_step + 4095;
    resumed.play_to(std::min(last_step, resumed.steps()));
    resumed.finish();
    ASSERT_EQ(trace.blocks().size(), 1u);
    EXPECT_EQ(trace.blocks()[0], whole.trace.blocks()[block]);
  }
}

TEST(ResumedReplay, MakesSkippedBlocksAgainFromTheirKeyframes) {
  const Scenario scenario = fling_at(60.0, 60'000);
  const Played whole(scenario);
  ASSERT_LT(whole.summary.steps_computed, whole.summary.steps);
  for (const Keyframe& keyframe : whole.trace.keyframes()) {
    TraceSink trace;
    Replay resumed(scenario, keyframe, trace, {.skips_repetition = false});
    resumed.play_to(std::min(keyframe.row.step + 4095, resumed.steps()));
    resumed.finish();
    const auto block = static_cast<std::size_t>(keyframe.row.step / 4096);
    EXPECT_EQ(trace.blocks()[0], whole.trace.blocks()[block]);
    EXPECT_EQ(whole.trace.blocks()[block].first_step, keyframe.row.step);
    EXPECT_TRUE(same_row(keyframe.row, whole.trace.rows()[static_cast<std::size_t>(keyframe.row.step)]));
  }
}

TEST(ResumedReplay, CountsNoContactThatWasCountedBefore) {
  // At rest on the ground at 240 Hz: one contact that does not end.
  const Scenario scenario = fling_at(240.0, 4000);
  const Played whole(scenario);
  const Contact& rest = whole.trace.contacts().back();
  ASSERT_EQ(rest.last_step, 4000);
  TraceSink trace;
  Replay resumed(scenario, stop_at(scenario, rest.step + 5), trace);
  resumed.play_to(resumed.steps());
  EXPECT_EQ(resumed.finish().contacts, WallCounts{});
}

// Control: a keyframe that is off by one bit does not go unseen.
TEST(ResumedReplay, DiffersFromAKeyframeThatIsOneUlpOff) {
  const Scenario scenario = fling_at(60.0, 100);
  const Played whole(scenario);
  Keyframe keyframe = stop_at(scenario, 50);
  keyframe.row.vy_px_per_s = std::nextafter(keyframe.row.vy_px_per_s, 1e9);
  TraceSink trace;
  Replay resumed(scenario, keyframe, trace);
  resumed.play_to(resumed.steps());
  resumed.finish();
  EXPECT_FALSE(same_rows(trace.rows(), rows_after(whole.trace.rows(), 50)));
}

void expect_same_in_pieces(const Scenario& scenario, std::uint64_t seed, std::int64_t piece_max) {
  const Played whole(scenario);
  TraceSink trace;
  Replay run(scenario, trace);
  for (std::uint64_t k = 0; run.keyframe().row.step < run.steps(); ++k) {
    const auto piece =
        static_cast<std::int64_t>(split_mix64(seed, k) % static_cast<std::uint64_t>(piece_max));
    run.play_to(std::min(run.keyframe().row.step + piece, run.steps()));
  }
  const RunSummary summary = run.finish();
  EXPECT_TRUE(same_trace(trace, whole.trace)) << "seed " << seed;
  EXPECT_EQ(summary.state_hash, whole.summary.state_hash);
  EXPECT_EQ(summary.contacts, whole.summary.contacts);
  EXPECT_EQ(summary.clamped_steps, whole.summary.clamped_steps);
  EXPECT_EQ(summary.rest_steps, whole.summary.rest_steps);
  EXPECT_EQ(summary.at_rest_since_s, whole.summary.at_rest_since_s);
}

TEST(ReplayInPieces, ComesToTheSameRun) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) expect_same_in_pieces(eventful_fling(), seed, 9);
}

TEST(ReplayInPieces, ComesToTheSameRunWhereItRepeats) {
  for (const std::int64_t piece_max : {50, 3000, 30'000})
    for (std::uint64_t seed = 0; seed < 5; ++seed)
      expect_same_in_pieces(fling_at(60.0, 30'000), seed, piece_max);
}

}  // namespace
}  // namespace hyrax
