// A run that is cut, stopped and resumed has the same bits.
#include <gtest/gtest.h>

#include <array>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

struct Played {
  explicit Played(const Scenario& scenario) { summary = replay(shipped_core(), scenario, trace); }
  TraceSink trace;
  RunSummary summary;
};

Keyframe stop_at(const Scenario& scenario, std::int64_t step) {
  TraceSink trace;
  Replay run(shipped_core(), scenario, trace);
  run.play_to(step);
  return run.keyframe();
}

// The rows or contacts of later steps.
template <class Element>
std::vector<Element> after(std::vector<Element> elements, std::int64_t step) {
  std::erase_if(elements, [&](const Element& element) { return element.step <= step; });
  return elements;
}

void expect_resumable_everywhere(const Scenario& scenario) {
  const Played whole(scenario);
  for (std::int64_t step = 0; step <= whole.summary.steps; ++step) {
    const Keyframe keyframe = stop_at(scenario, step);
    ASSERT_TRUE(same_row(keyframe.row, whole.trace.rows()[static_cast<std::size_t>(step)]));
    TraceSink trace;
    Replay resumed(shipped_core(), scenario, keyframe, trace);
    resumed.play_to(resumed.steps());
    const RunSummary summary = resumed.finish();
    ASSERT_TRUE(same_rows(trace.rows(), after(whole.trace.rows(), step))) << "from " << step;
    ASSERT_TRUE(same_contacts(trace.contacts(), after(whole.trace.contacts(), step))) << "from " << step;
    ASSERT_TRUE(same_row(summary.final, whole.summary.final)) << "from " << step;
  }
}

// Also of a rest that repeats, and of a recorded trace.
TEST(ResumedReplay, ContinuesWithTheSameBitsFromEveryRow) {
  Scenario traced = fling_at(60.0, 0);
  RecordedSteps trace;
  for (int frame = 0; frame < 200; ++frame) trace.dt_s.push_back(frame % 7 == 0 ? 0.0333 : 0.0167);
  traced.clock.base = trace;
  traced.length = {};
  for (const Scenario& scenario : {eventful_fling(), fling_at(240.0, 1500), traced})
    expect_resumable_everywhere(scenario);
}

TEST(ResumedReplay, CountsNoContactThatWasCountedBefore) {
  // At rest on the ground at 240 Hz: one contact that does not end.
  const Scenario scenario = fling_at(240.0, 4000);
  const Played whole(scenario);
  const Contact& rest = whole.trace.contacts().back();
  ASSERT_EQ(rest.last_step, 4000);
  TraceSink trace;
  Replay resumed(shipped_core(), scenario, stop_at(scenario, rest.step + 5), trace);
  resumed.play_to(resumed.steps());
  EXPECT_EQ(resumed.finish().contacts, WallCounts{});
}

// In pieces of 0 .. piece_max - 1 frames, or of one frame.
void expect_same_in_pieces(const Scenario& scenario, std::uint64_t seed, std::int64_t piece_max,
                           RowSink::Wants wants = {.rows_every = 1, .contacts = true, .blocks = true},
                           bool skips_repetition = true) {
  const ReplayOptions options{.skips_repetition = skips_repetition, .checks_bounds = true};
  TraceSink whole(wants);
  const RunSummary whole_summary = replay(shipped_core(), scenario, whole, options);
  TraceSink trace(wants);
  Replay run(shipped_core(), scenario, trace, options);
  for (std::uint64_t k = 0; run.keyframe().row.step < whole_summary.steps; ++k) {
    const auto piece =
        static_cast<std::int64_t>(split_mix64(seed, k) % static_cast<std::uint64_t>(piece_max));
    run.play_to(std::min(run.keyframe().row.step + piece, run.steps()));
  }
  EXPECT_EQ(text_of(run.finish()), text_of(whole_summary)) << "seed " << seed << ", pieces " << piece_max;
  EXPECT_TRUE(same_trace(trace, whole)) << "seed " << seed << ", pieces " << piece_max;
}

TEST(ReplayInPieces, GivesTheSameRun) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) expect_same_in_pieces(eventful_fling(), seed, 9);
  Scenario non_finite = fling_at(1e-9, 50, {{std::int64_t{30}, Fling{{1.0, 1.0}}}});
  non_finite.start_velocity = {1e12, 1e12};
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    expect_same_in_pieces(non_finite, seed, 5);
    for (const std::int64_t piece_max : {2, 50, 3000, 30'000})  // It repeats.
      expect_same_in_pieces(fling_at(60.0, 30'000), seed, piece_max);
  }
  // A sprite wider than its window touches both walls in turn forever: the list of contacts fills up within
  // a piece, and later ones begin with a full list.
  Scenario knocking = fling_at(60.0, kContactsRecordedMax + 20'000);
  knocking.window = {100, 1080};
  expect_same_in_pieces(knocking, 1, 7'000, {.rows_every = 0, .contacts = true});
  // Computes a period once however long it repeats.
  expect_same_in_pieces(fling_at(60.0, 100'000'000), 1, 1 << 21, {});
}

TEST(ReplayInPieces, GivesTheSameRunInRandomFlings) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Scenario scenario = any_fling(seed, 12'000);
    if (seed % 8 == 7) scenario.clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.3, seed};
    const std::int64_t piece_max = std::array{2, 5, 100, 1000, 5000, 12'000}[seed % 6];
    const RowSink::Wants wants{
        .rows_every = std::array{0, 1, 7}[seed % 3], .contacts = true, .blocks = seed % 2 == 0};
    expect_same_in_pieces(scenario, seed, piece_max, wants, seed % 5 != 0);
  }
}

}  // namespace
}  // namespace hyrax
