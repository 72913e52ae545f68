#include "tools/hyrax/playback.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

constexpr std::int64_t kTicksPerS = 1000;

Scenario fling_with_hash(const std::string& hash) {
  Scenario scenario = fling_at(60.0, 120);
  scenario.expect.emplace().state_hash = hash;
  return scenario;
}

std::string right_hash() { return hex(replay(shipped_core(), fling_at(60.0, 120)).state_hash); }

TEST(Playback, KeepsThePaceOfTheScenariosClock) {
  const Scenario scenario = fling_at(60.0, 120);
  Playback playback(shipped_core(), scenario, kTicksPerS, 500);
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
  Playback playback(shipped_core(), agreeing, kTicksPerS, 0);
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

TEST(Playback, ThatIsEndedEarlyDoesNotAgreeWithAHash) {
  for (const bool expects_hash : {true, false}) {
    const Scenario scenario = expects_hash ? fling_with_hash(right_hash()) : fling_at(60.0, 120);
    Playback playback(shipped_core(), scenario, kTicksPerS, 0);
    playback.play(kTicksPerS);
    const PlaybackVerdict verdict = playback.finish();
    EXPECT_EQ(verdict.exit_code, expects_hash ? ExitCode::disagreed : ExitCode::agreed);
    EXPECT_EQ(verdict.sentence, "fling: ended at step 60 of 120; the state hash was not compared");
  }
}

TEST(Playback, EndsWhereTheStateBecomesNonFinite) {
  Scenario scenario = fling_at(60.0, 1000);
  scenario.start_velocity.vy_px_per_s = std::numeric_limits<double>::infinity();
  Playback playback(shipped_core(), scenario, kTicksPerS, 0);
  playback.play(kTicksPerS);
  EXPECT_TRUE(playback.is_over());
  EXPECT_EQ(playback.now().row.step, 1);
  const PlaybackVerdict verdict = playback.finish();
  EXPECT_EQ(verdict.exit_code, ExitCode::disagreed);
  EXPECT_EQ(verdict.sentence, "fling: vy is infinite from step 1 of 1000 (0.017 s)");
}

TEST(Playback, StaysAwakeWhenFramesAreTooShortForTheirTime) {
  Scenario scenario = fling_at(1e9, 0);
  scenario.length = std::int64_t{1'000'000'000'000};
  Playback playback(shipped_core(), scenario, kTicksPerS, 0);
  playback.play(10 * kTicksPerS);
  EXPECT_LT(playback.now().row.step, 1'000'000);
}

}  // namespace
}  // namespace hyrax
