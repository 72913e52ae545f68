// The time rule against the published vectors.
#include "sim/scenario/frame_clock.h"

#include <gtest/gtest.h>

#include "tests/oracle/vectors.h"

namespace hyrax {
namespace {

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

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

TEST(Timeline, BeginsAtZero) { EXPECT_EQ(bits(Timeline{}.time_s()), bits(0.0)); }

TEST(Timeline, PlaysEqualFramesAtOnceToTheSameTime) {
  Timeline at_once;
  Timeline one_by_one;
  for (const double dt_s : {0.1, 1.0 / 60.0, 0.5}) {
    at_once.play(dt_s, 1000);
    for (int frame = 0; frame < 1000; ++frame) one_by_one.play(dt_s);
    EXPECT_EQ(at_once, one_by_one);
    EXPECT_EQ(bits(at_once.time_s()), bits(one_by_one.time_s()));
  }
}

TEST(Timeline, PredictsTheTimeOfALaterFrame) {
  Timeline timeline;
  timeline.play(0.5);
  timeline.play(0.1, 3);
  const double ahead_s = timeline.time_s(40);
  timeline.play(0.1, 40);
  EXPECT_EQ(bits(ahead_s), bits(timeline.time_s()));
}

TEST(Timeline, DoesNotDriftOverALongRun) {
  Timeline timeline;
  timeline.play(0.1, 1'000'000'000'000);
  EXPECT_EQ(timeline.time_s(), 1e12 * 0.1);
}

TEST(Timeline, KeepsShortFramesAfterALongOne) {
  Timeline timeline;
  timeline.play(1e9);
  for (int frame = 0; frame < 1000; ++frame) {
    timeline.play(1e-9);
    timeline.play(0.0);
  }
  EXPECT_EQ(timeline.time_s(), 1e9 + 1e-6);
  // Control: the plain sum loses every one of the small frames.
  double plain_s = 1e9;
  for (int frame = 0; frame < 1000; ++frame) plain_s += 1e-9;
  EXPECT_EQ(plain_s, 1e9);
}

}  // namespace
}  // namespace hyrax
