// The dt of every frame, its time, and the number of frames, against the published vectors.
#include "sim/scenario/frame_clock.h"

#include <gtest/gtest.h>

#include <bit>

#include "sim/scenario/split_mix64.h"
#include "tests/oracle/vectors.h"

namespace hyrax {
namespace {

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

Jitter jitter_of(const Json& entry) {
  const std::string& kind = text_of(entry, "kind");
  if (kind == "uniform") return {Jitter::Kind::uniform, exact(entry, "fraction"), bits_of(entry, "seed")};
  if (kind == "normal") return {Jitter::Kind::normal, exact(entry, "sigma_s"), bits_of(entry, "seed")};
  return {Jitter::Kind::missed_frames, exact(entry, "probability"), bits_of(entry, "seed")};
}

Scenario of_length(Clock clock, std::variant<std::monostate, std::int64_t, double> length) {
  Scenario scenario;
  scenario.clock = std::move(clock);
  scenario.length = length;
  return scenario;
}

TEST(SplitMix64, DrawsThePublishedOutputs) {
  for (const Json& entry : vectors("splitmix64"))
    for (const Json& draw : *entry.find("draws")->get<Json::Array>()) {
      const auto k = static_cast<std::uint64_t>(integer_of(draw, "k"));
      EXPECT_EQ(split_mix64(bits_of(entry, "seed"), k), bits_of(draw, "output")) << "k " << k;
      EXPECT_EQ(bits(split_mix64_unit(bits_of(entry, "seed"), k)), bits(exact(draw, "u"))) << "k " << k;
    }
}

TEST(Jitter, DrawsThePublishedFrames) {
  for (const Json& entry : vectors("jitter")) {
    const Jitter jitter = jitter_of(entry);
    const std::vector<double> frames_dt_s = exact_list(entry, "frames_dt_s");
    for (std::size_t frame = 0; frame < frames_dt_s.size(); ++frame)
      EXPECT_EQ(bits(jittered_dt_s(exact(entry, "dt_s"), jitter, static_cast<std::int64_t>(frame))),
                bits(frames_dt_s[frame]))
          << text_of(entry, "kind") << " seed " << jitter.seed << " frame " << frame;
  }
}

TEST(FrameClock, OfAStepKeepsItsBits) {
  const Clock clock{FixedStep{-0.0}, {}};
  EXPECT_EQ(bits(FrameClock(clock).dt_s(7)), bits(-0.0));
}

TEST(Timeline, GivesThePublishedTimes) {
  for (const Json& entry : vectors("time_rule")) {
    const std::vector<double> dts_s = exact_list(entry, "dts_s");
    const std::vector<double> times_s = exact_list(entry, "times_s");
    Timeline timeline;
    for (std::size_t frame = 0; frame < dts_s.size(); ++frame) {
      timeline.play(dts_s[frame]);
      EXPECT_EQ(bits(timeline.time_s()), bits(times_s[frame]))
          << text_of(entry, "name") << ", frame " << frame;
    }
  }
}

TEST(Timeline, DoesNotDriftOverALongRun) {
  Timeline timeline;
  timeline.play(0.1, 1'000'000'000'000);
  EXPECT_EQ(timeline.time_s(), 1e12 * 0.1);
}

TEST(StepCount, OfADurationIsThePublishedOne) {
  for (const Json& entry : vectors("steps")) {
    const Clock clock{FixedStep{exact(entry, "dt_s")}, {}};
    EXPECT_EQ(step_count(of_length(clock, exact(entry, "duration_s"))), integer_of(entry, "steps"))
        << text_of(entry, "duration_s") << " of " << text_of(entry, "dt_s");
  }
}

TEST(StepCount, OfADurationPastTheLimitExceedsTheLimit) {
  EXPECT_EQ(step_count(of_length({FixedStep{1e-9}, {}}, 1e3)), kStepsMax);
  EXPECT_EQ(step_count(of_length({FixedStep{1e-9}, {}}, 1001.0)), kStepsMax + 1);
  EXPECT_EQ(step_count(of_length({FixedStep{5e-324}, {}}, 1e308)), kStepsMax + 1);
}

TEST(PlaysTheSame, DetectsEveryChangeThatAffectsTheRun) {
  const Scenario a = of_length({FixedRate{60.0}, {}}, std::int64_t{10});
  std::vector<Scenario> others(8, a);
  others[0].window.width_px = 1;
  others[1].sprite.height_px = 1;
  others[2].start.x_px = 1.0;
  others[3].start_velocity.vy_px_per_s = 1.0;
  others[4].clock.jitter = Jitter{};
  others[5].length = std::int64_t{11};
  others[6].events.push_back({std::int64_t{1}, Stop{}});
  others[7].record_every = 2;
  for (const Scenario& other : others) EXPECT_FALSE(plays_the_same(a, other)) << &other - others.data();
  const Clock trace{RecordedSteps{{0.1, 0.2}}, {}};  // Whose steps are its length.
  EXPECT_TRUE(plays_the_same(of_length(trace, {}), of_length(trace, std::int64_t{2})));
}

TEST(LongestFrame, DependsOnTheKindOfJitter) {
  const auto longest_s = [](Jitter::Kind kind, double amount, double dt_s) {
    return longest_dt_s({FixedStep{dt_s}, Jitter{kind, amount, 1}});
  };
  EXPECT_EQ(longest_dt_s({FixedStep{0.25}, {}}), 0.25);
  EXPECT_EQ(longest_s(Jitter::Kind::uniform, 1.0, 0.25), 0.5);
  EXPECT_EQ(longest_s(Jitter::Kind::missed_frames, 0.1, 0.25), 0.5);
  EXPECT_EQ(longest_s(Jitter::Kind::normal, 1.0, 0.25), 6.25);
  EXPECT_EQ(longest_s(Jitter::Kind::normal, kFrameMax_s, 0.25), kFrameMax_s);
}

}  // namespace
}  // namespace hyrax
