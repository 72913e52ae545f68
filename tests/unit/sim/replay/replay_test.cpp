// The replay against the frame rule played plainly, the run's ends, and what sinks take of it.
#include "sim/replay/replay.h"

#include <gtest/gtest.h>

#include "sim/core/core.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/replay/fingerprint.h"
#include "sim/scenario/frame_clock.h"
#include "sim/search/draws.h"
#include "sim/trajectory/waypoints.h"
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
  WallCounts contacts{}, bounces{};
  for (const Contact& contact : plain.contacts) {
    ++contacts[contact.wall];
    if (!plain.is_resting(contact)) ++bounces[contact.wall];
  }
  EXPECT_EQ(summary.contacts, contacts) << which;
  EXPECT_EQ(summary.bounces, bounces) << which;
  EXPECT_EQ(summary.resting_contact_from_step, plain.resting_contact_from_step()) << which;
  for (const Wall wall : kWalls)
    EXPECT_EQ(summary.clamped_steps[wall], plain.steps_with(static_cast<std::uint8_t>(wall))) << which;
}

TEST(Replay, PlaysEveryKindOfInputAndRandomFlingsByTheFrameRule) {
  expect_plain_run(eventful_fling(), "eventful");
  for (std::uint64_t seed = 0; seed < 300; ++seed)
    expect_plain_run(any_fling(seed, 1000), "seed " + std::to_string(seed));
}

// Contacts that rest, that rest until an input, that go on over one, and those of a sprite that bounces for
// ever.
TEST(Replay, TellsRestingContactFromBounces) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Draws draws(seed);
    constexpr double kRates_hz[] = {20.0, 60.0, 100.0, 144.0};
    Scenario scenario = fling_at(draws.one_of(kRates_hz), 900);
    scenario.start = {draws.between(0.0, 1700.0), draws.between(600.0, 952.0)};
    scenario.start_velocity = {draws.between(-100.0, 100.0), draws.between(-200.0, 0.0)};
    if (draws.below(2) == 1) scenario.clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.2, seed};
    for (std::int64_t frame = 0; draws.below(5) > 0 && frame < 800;
         frame += static_cast<std::int64_t>(draws.below(200)))
      scenario.events.push_back({frame, draws.below(2) == 1
                                            ? Action(Hitch{draws.between(0.0, 0.2)})
                                            : Action(Fling{{0.0, draws.between(-90.0, 30.0)}})});
    expect_plain_run(scenario, "seed " + std::to_string(seed));
  }
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

TEST(Tee, GivesEachSinkWhatItWouldGetAlone) {
  const RowSink::Wants all[] = {{.rows_every = 1},
                                {.rows_every = 7, .contacts = true},
                                {.contacts = true, .blocks = true},
                                {.rows_every = 4096, .blocks = true},
                                {}};
  for (const Scenario& scenario : {eventful_fling(), fling_at(60.0, 20'000), fling_at(60.0, 0)}) {
    TraceSink together[] = {TraceSink(all[0]), TraceSink(all[1]), TraceSink(all[2]), TraceSink(all[3]),
                            TraceSink(all[4])};
    std::vector<RowSink*> sinks;
    for (TraceSink& sink : together) sinks.push_back(&sink);
    const RunSummary summary = replay(shipped_core(), scenario, sinks);
    for (std::size_t index = 0; index < std::size(together); ++index) {
      TraceSink alone(all[index]);
      EXPECT_EQ(replay(shipped_core(), scenario, alone).state_hash, summary.state_hash);
      EXPECT_TRUE(same_trace(together[index], alone)) << index;
    }
  }
}

// Every row up to 5,000, then every 1,000th; from row 12,000 on nothing.
class FewerAndFewer : public RowSink {
 public:
  Wants wants() const override {
    return {.rows_every = steps.empty() || steps.back() < 12'000 ? 1000 : 0, .all_rows_to = 5000};
  }
  void row(const Row& row) override { steps.push_back(row.step); }
  void repeats(const Repetition& found) override { repetition = found; }
  std::vector<std::int64_t> steps;
  Repetition repetition;
};

TEST(Tee, GivesASinkFewerRowsWhenItRequestsFewer) {
  FewerAndFewer sink;
  const RunSummary summary = replay(shipped_core(), fling_at(60.0, 10'000'000), sink);
  ASSERT_GT(sink.steps.size(), 5001u);
  for (std::int64_t step = 0; step <= 5000; ++step)
    ASSERT_EQ(sink.steps[static_cast<std::size_t>(step)], step);
  EXPECT_EQ(sink.steps[5001], 6000);
  EXPECT_EQ(sink.steps[5002], 7000);
  EXPECT_LT(sink.steps.size(), 10'001u);  // It is queried again after 4,096 rows.
  EXPECT_EQ(sink.repetition.from_step, summary.periodic_from_step);
  EXPECT_EQ(sink.repetition.period_steps, summary.period_steps);
}

TEST(Fingerprint, IsTheSameForTheSameBitsAndDependsOnEveryConstant) {
  EXPECT_EQ(fingerprint_of(listing_core(*shipped_core().constants)), fingerprint_of(shipped_core()));
  for (double Constants::*constant :
       {&Constants::gravity_px_per_s2, &Constants::restitution, &Constants::air_drag,
        &Constants::ground_friction, &Constants::rest_threshold_px_per_s}) {
    Constants changed = *shipped_core().constants;
    // A threshold decides; the others are factors of every step.
    changed.*constant *= constant == &Constants::rest_threshold_px_per_s ? 1.1 : 1.0 + 0x1p-50;
    EXPECT_NE(fingerprint_of(listing_core(changed)), fingerprint_of(shipped_core()));
  }
}

void expect_same(const Row& a, const Row& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_TRUE(same_bits(a.t_s, b.t_s));
  EXPECT_TRUE(same_bits(state_of(a), state_of(b)));
}

void expect_same_waypoints(const Scenario& scenario) {
  WaypointMeter blocks(step_count(scenario));
  WaypointMeter rows(0);  // Gets every row, as of a short run.
  replay(shipped_core(), scenario, {&blocks, &rows});
  const Waypoints a = blocks.take();
  const Waypoints b = rows.take();
  expect_same(a.apex, b.apex);
  ASSERT_EQ(a.at_seconds.size(), b.at_seconds.size());
  for (std::size_t second = 0; second < a.at_seconds.size(); ++second)
    expect_same(a.at_seconds[second], b.at_seconds[second]);
}

// The last two settle after 7 of 9 and 15 s; of those before a second ends with a block, or nearly.
TEST(WaypointsOfBlocks, AreThoseOfEveryRow) {
  for (const auto& [rate_hz, steps] : {std::pair{60.0, 20'000},
                                       {1000.0, 20'000},
                                       {2048.0, 24'576},
                                       {4095.0, 49'140},
                                       {4096.0, 49'152},
                                       {4097.0, 49'164},
                                       {8192.0, 98'304},
                                       {100'000.0, 900'000},
                                       {100'000.0, 1'500'000}}) {
    SCOPED_TRACE(rate_hz);
    expect_same_waypoints(fling_at(rate_hz, steps));
  }
}

TEST(WaypointsOfBlocks, TheApexMayComeLate) {
  expect_same_waypoints(fling_at(60.0, 20'000, {{std::int64_t{15'000}, Place{{700.0, -5.0}}}}));
}

}  // namespace
}  // namespace hyrax
