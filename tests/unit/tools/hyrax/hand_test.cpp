#include "tools/hyrax/hand.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

constexpr std::int64_t kTicksPerS = 10'000'000;
constexpr std::int64_t kMs = kTicksPerS / 1000;

Hold hand_at(ScreenPoint at, std::int64_t ticks = 0) { return {kTicksPerS, at, ticks, {}, {}}; }

// A hand that moves by `way` every `period_ms`, `moves` times.
Hold moved_hand(ScreenPoint way, std::int64_t period_ms, int moves) {
  Hold hand = hand_at({500, 400});
  for (int move = 1; move <= moves; ++move)
    hand.move({500 + move * way.x_px, 400 + move * way.y_px}, move * period_ms * kMs);
  return hand;
}

TEST(Hand, GivesItsMeanVelocityOverTheLastTenthOfASecond) {
  const Hold hand = moved_hand({12, -9}, 10, 30);
  EXPECT_EQ(hand.velocity(300 * kMs), (Velocity{1200.0, -900.0}));
  EXPECT_EQ(hand.velocity(350 * kMs), (Velocity{600.0, -450.0})) << "slows down";
  EXPECT_EQ(hand.velocity(400 * kMs), Velocity{}) << "stopped before it let go";
  EXPECT_EQ(hand.velocity(60'000 * kMs), Velocity{});
}

TEST(Hand, IgnoresOlderMoves) {
  Hold hand = hand_at({0, 0});
  hand.move({-900, 300}, 100 * kMs);
  for (int move = 1; move <= 10; ++move) hand.move({-900 + 5 * move, 300}, (100 + 10 * move) * kMs);
  EXPECT_EQ(hand.velocity(200 * kMs), (Velocity{500.0, 0.0}));
}

TEST(Hand, OfAShortFlickOrOfSeldomMessagesGivesTheVelocityOfThese) {
  EXPECT_EQ(moved_hand({20, 0}, 10, 4).velocity(40 * kMs), (Velocity{2000.0, 0.0}));
  EXPECT_EQ(moved_hand({40, 0}, 80, 2).velocity(160 * kMs), (Velocity{800.0, 0.0}));
}

TEST(Hand, HasDraggedForTenMillisecondsAtLeast) {
  Hold hand = hand_at({0, 0}, 50);
  EXPECT_EQ(hand.velocity(50), Velocity{});
  hand.move({1, 0}, 51);
  EXPECT_EQ(hand.velocity(52), (Velocity{100.0, 0.0}));
  hand.move({30, -10}, 51);
  EXPECT_EQ(hand.velocity(51), (Velocity{3000.0, -1000.0}));
}

}  // namespace
}  // namespace hyrax
