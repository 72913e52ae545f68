// A recorded session is a scenario that replays to the same bits; a scenario is played at the pace of its
// clock.
#include <gtest/gtest.h>

#include <limits>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/split_mix64.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"
#include "tools/hyrax/pet.h"
#include "tools/hyrax/playback.h"
#include "tools/recorder/tape.h"

namespace hyrax {
namespace {

Keyframe start() {
  Keyframe start;
  start.row.x_px = 300.0;
  start.row.y_px = 500.0;
  start.row.vx_px_per_s = 2400.0;
  start.row.vy_px_per_s = -0.0;
  start.window = kDesktopWindow;
  start.sprite = kHyrax;
  return start;
}

// A jittery display of 60 Hz, sometimes with two frames at the same time.
double dt_s(std::int64_t frame) {
  const double draw = split_mix64_unit(11, static_cast<std::uint64_t>(frame));
  return draw < 0.01 ? 0.0 : 0.0167 + 0.004 * (draw - 0.5);
}

void play(Session& session, std::int64_t frames) {
  for (std::int64_t frame = 0; frame < frames; ++frame) session.advance(dt_s(session.now().row.step));
}

// All kinds of inputs, and the frames between them.
void live(Session& session) {
  play(session, 200);
  session.apply(Grab{});
  for (int move = 0; move < 20; ++move) {
    session.apply(Place{{500.0 + 10 * move, 300.25 - move}});
    session.advance(dt_s(session.now().row.step));
  }
  session.apply(Release{{1300.5, -900.25}});
  play(session, 50);
  session.apply(Resize{Size{1280, 700}, Size{160, 160}});
  session.apply(Place{{-20.0, 30.0}});
  play(session, 100);
  session.apply(Stop{});
  session.apply(Fling{{-700.0, -1500.0}});
  play(session, 300);
}

// The summary of replaying its scenario file.
RunSummary replayed_from_text(const Tape& tape) {
  const Scenario read = parse_scenario(scenario_file_text(tape.scenario("tape")), "tape");
  return replay(shipped_core(), read);
}

void expect_replays(const Tape& tape, const Keyframe& end) {
  const RunSummary summary = replayed_from_text(tape);
  EXPECT_EQ(hex(summary.state_hash), hex(tape.state_hash()));
  EXPECT_EQ(tape.scenario("tape").expect->state_hash, hex(summary.state_hash));
  EXPECT_EQ(summary.steps, tape.frames());
  EXPECT_TRUE(same_bits(summary.final.x_px, end.row.x_px));
  EXPECT_TRUE(same_bits(summary.final.vy_px_per_s, end.row.vy_px_per_s));
}

TEST(Tape, OfASessionReplaysToTheSameBitsWithoutInputsOfAFrameToCome) {
  Session session(shipped_core(), start());
  play(session, 4);
  expect_replays(session.just_happened(), session.now());
  session.apply(Grab{});
  const Tape held = session.just_happened();
  EXPECT_TRUE(held.scenario("tape").events.empty());
  EXPECT_EQ(hex(replayed_from_text(held).state_hash), hex(held.state_hash()));
  session.apply(Release{{5.0, 6.0}});
  live(session);
  expect_replays(session.just_happened(), session.now());
}

// A control: the hash is of what was shown, not of its replay.
TEST(Tape, WithAnotherStateThanTheModelsDoesNotReplay) {
  Session session(shipped_core(), start());
  Tape tape(session.now());
  play(session, 1);
  Row row = session.now().row;
  row.x_px += 1e-9;
  tape.add_frame(row);
  EXPECT_NE(hex(replayed_from_text(tape).state_hash), hex(tape.state_hash()));
}

TEST(Tape, ThatBeginsInAHoldBeginsWithAGrab) {
  for (const Velocity velocity : {Velocity{5.0, 0.0}, {0.0, -0.0}}) {
    Session session(shipped_core(), start());
    session.apply(Grab{});
    play(session, 3);
    session.apply(Fling{velocity});  // While it is held: the speed stays, and nothing moves.
    play(session, 1);
    Tape tape(session.now());
    const auto keep = [&](const Action& action) {
      session.apply(action);
      tape.add_input(action);
    };
    const auto keep_frames = [&](int frames) {
      for (int frame = 0; frame < frames; ++frame) {
        play(session, 1);
        tape.add_frame(session.now().row);
      }
    };
    keep_frames(5);
    keep(Place{{10.0, 20.0}});
    keep_frames(2);
    keep(Release{{100.0, -100.0}});
    keep_frames(50);
    expect_replays(tape, session.now());
  }
}

TEST(Ring, LetsTheOldestGoAndStillReplays) {
  Session session(shipped_core(), start());
  constexpr auto kTapes = static_cast<std::int64_t>(Ring::kTapesMax);
  while (session.now().row.step < 3 * Ring::kTapeFrames * kTapes) live(session);
  const Tape tape = session.just_happened();
  EXPECT_EQ(tape.frames() / Ring::kTapeFrames, kTapes - 1) << "and those of the tape that is not full";
  expect_replays(tape, session.now());
}

constexpr std::int64_t kTapeTicksPerS = 1000;

Scenario fling_with_hash(const std::string& hash) {
  Scenario scenario = fling_at(60.0, 120);
  scenario.expect.emplace().state_hash = hash;
  return scenario;
}

std::string right_hash() { return hex(replay(shipped_core(), fling_at(60.0, 120)).state_hash); }

TEST(Playback, KeepsThePaceOfTheScenariosClock) {
  const Scenario scenario = fling_at(60.0, 120);
  Playback playback(shipped_core(), scenario, kTapeTicksPerS, 500);
  playback.play(500);
  EXPECT_EQ(playback.now().row.step, 0);
  playback.play(1500);
  EXPECT_EQ(playback.now().row.step, 60);
  EXPECT_FALSE(playback.is_over());
  playback.play(9000);
  EXPECT_TRUE(playback.is_over());
}

TEST(Playback, IsJudgedByItsHashWhenItIsPlayedOrReplayed) {
  const Scenario agreeing = fling_with_hash(right_hash());
  const PlaybackVerdict same = replayed(shipped_core(), agreeing);
  EXPECT_EQ(same.exit_code, ExitCode::agreed);
  EXPECT_EQ(same.sentence, "fling: state hash " + right_hash() + " agrees");
  Playback playback(shipped_core(), agreeing, kTapeTicksPerS, 0);
  for (std::int64_t ticks = 0; !playback.is_over(); ticks += 17) playback.play(ticks);
  EXPECT_EQ(playback.finish().sentence, same.sentence);
  const PlaybackVerdict other = replayed(shipped_core(), fling_with_hash(std::string(32, '0')));
  EXPECT_EQ(other.exit_code, ExitCode::disagreed);
  EXPECT_EQ(other.sentence,
            "fling: state hash differs (found " + right_hash() + "); expected " + std::string(32, '0'));
  Scenario expects_another = fling_at(60.0, 120);
  expects_another.expect.emplace().in_bounds = true;
  for (const Scenario& scenario : {fling_at(60.0, 120), expects_another}) {
    const PlaybackVerdict none = replayed(shipped_core(), scenario);
    EXPECT_EQ(none.exit_code, ExitCode::agreed);
    EXPECT_EQ(none.sentence, "fling: state hash " + right_hash() + "; the scenario expects none");
  }
}

TEST(Playback, EndsWhereTheStateBecomesNonFinite) {
  Scenario scenario = fling_at(60.0, 1000);
  scenario.start_velocity.vy_px_per_s = std::numeric_limits<double>::infinity();
  Playback playback(shipped_core(), scenario, kTapeTicksPerS, 0);
  playback.play(kTapeTicksPerS);
  EXPECT_TRUE(playback.is_over());
  EXPECT_EQ(playback.now().row.step, 1);
  const PlaybackVerdict verdict = playback.finish();
  EXPECT_EQ(verdict.exit_code, ExitCode::disagreed);
  EXPECT_EQ(verdict.sentence, "fling: vy is infinite from step 1 of 1000 (0.017 s)");
}

TEST(Playback, StaysAwakeWhenFramesAreTooShortForTheirTime) {
  Scenario scenario = fling_at(1e9, 0);
  scenario.length = std::int64_t{1'000'000'000'000};
  Playback playback(shipped_core(), scenario, kTapeTicksPerS, 0);
  playback.play(10 * kTapeTicksPerS);
  EXPECT_LT(playback.now().row.step, 1'000'000);
}

TEST(LoadForPet, RefusesOtherConstantsThanThePets) {
  const TempFolder folder;
  const std::string path = folder.at("calm.json");
  Scenario calm = fling_at(60.0, 120);
  write_text_file(path, scenario_file_text(calm));
  EXPECT_EQ(load_for_pet(path).name, "fling");
  calm.parameters.push_back({"GRAVITY", 980.0});
  write_text_file(path, scenario_file_text(calm), true);
  EXPECT_EQ(refusal_of([&] { static_cast<void>(load_for_pet(path)); }),
            path + ": /parameters: hyrax plays its own constants only; hyrax-sim run plays these");
}

}  // namespace
}  // namespace hyrax
