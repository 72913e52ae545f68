// The desk: positions on the screen, its changes, and the velocity of a hand.
#include <gtest/gtest.h>

#include <limits>

#include "tools/hyrax/desk.h"
#include "tools/hyrax/hand.h"

namespace hyrax {
namespace {

constexpr Desk kMain{{0, 0}, {1920, 1040}, {128, 128}};
constexpr Desk kLeftOfIt{{-1280, -200}, {1280, 984}, {160, 160}};

TEST(Desk, PutsAPositionOntoTheScreenOrAsFarAsAWindowCanBe) {
  EXPECT_EQ(on_screen(kMain, {100.4, 200.5}), (ScreenPoint{100, 201}));
  EXPECT_EQ(on_screen(kLeftOfIt, {0.0, 0.0}), (ScreenPoint{-1280, -200}));
  EXPECT_EQ(on_screen(kLeftOfIt, {-0.6, 10.0}), (ScreenPoint{-1281, -190}));
  EXPECT_EQ(on_screen(kMain, {1e12, -1e12}), (ScreenPoint{1'000'000, -1'000'000}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(on_screen(kMain, {nan, 0.0}).y_px, 0);
}

TEST(Desk, HasASpriteOfItsScalingAndARateOfItsDisplay) {
  EXPECT_EQ(sprite_at(96), (Size{128, 128}));
  EXPECT_EQ(sprite_at(97), (Size{129, 129}));
  EXPECT_EQ(sprite_at(140), (Size{187, 187}));
  EXPECT_EQ(sprite_at(0), (Size{1, 1}));
  for (const auto& [display_hz, rate_hz] :
       {std::pair{0, 60}, {1, 60}, {2, 30}, {30, 30}, {31, 31}, {239, 239}, {240, 240}, {360, 240}})
    EXPECT_EQ(frame_rate_hz(display_hz), rate_hz) << display_hz;
}

TEST(Desk, ThatChangesIsAResizeAndThePlaceOfTheSamePointOfTheScreen) {
  Desk smaller = kMain, sharper = kMain, below = kMain;
  smaller.work_area.height_px = 600;
  sharper.sprite = {192, 192};
  below.origin.y_px = 40;  // The task bar moves to the top.
  const Position place{-300.25, 100.5};
  using Inputs = std::vector<Action>;
  EXPECT_EQ(inputs_of_move(kMain, kMain, place), Inputs{});
  EXPECT_EQ(inputs_of_move(kMain, smaller, place), (Inputs{Resize{Size{1920, 600}, {}}}));
  EXPECT_EQ(inputs_of_move(kMain, sharper, place), (Inputs{Resize{{}, Size{192, 192}}}));
  EXPECT_EQ(inputs_of_move(kMain, below, place), (Inputs{Place{{-300.25, 60.5}}}));
  EXPECT_EQ(inputs_of_move(kMain, kLeftOfIt, place),
            (Inputs{Resize{Size{1280, 984}, Size{160, 160}}, Place{{979.75, 300.5}}}));
}

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
  EXPECT_EQ(moved_hand({20, 0}, 10, 4).velocity(40 * kMs), (Velocity{2000.0, 0.0})) << "a short flick";
  EXPECT_EQ(moved_hand({40, 0}, 80, 2).velocity(160 * kMs), (Velocity{800.0, 0.0})) << "seldom messages";
}

TEST(Hand, IgnoresOlderMovesAndHasDraggedForTenMillisecondsAtLeast) {
  Hold hand = hand_at({0, 0});
  hand.move({-900, 300}, 100 * kMs);
  for (int move = 1; move <= 10; ++move) hand.move({-900 + 5 * move, 300}, (100 + 10 * move) * kMs);
  EXPECT_EQ(hand.velocity(200 * kMs), (Velocity{500.0, 0.0}));
  hand = hand_at({0, 0}, 50);
  EXPECT_EQ(hand.velocity(50), Velocity{});
  hand.move({1, 0}, 51);
  EXPECT_EQ(hand.velocity(52), (Velocity{100.0, 0.0}));
  hand.move({30, -10}, 51);
  EXPECT_EQ(hand.velocity(51), (Velocity{3000.0, -1000.0}));
}

}  // namespace
}  // namespace hyrax
