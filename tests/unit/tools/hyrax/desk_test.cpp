// The desk: positions on the screen, its changes, and the velocity of a hand.
#include <gtest/gtest.h>

#include <limits>
#include <tuple>

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

TEST(Desk, ShowsALargerWindowScaledDown) {
  const auto shown = [](Size window, Size sprite, Position position) {
    const Shown on = shown_on(kLeftOfIt, window, sprite, position);
    return std::vector<int>{on.at.x_px, on.at.y_px, on.sprite.width_px, on.sprite.height_px};
  };
  EXPECT_EQ(shown({1280, 984}, {128, 100}, {10.25, 5.5}), (std::vector<int>{-1270, -194, 128, 100}));
  EXPECT_EQ(shown({640, 480}, {128, 100}, {10.25, 5.5}), (std::vector<int>{-1270, -194, 128, 100}));
  EXPECT_EQ(shown({5120, 100}, {128, 100}, {4992.0, 0.0}), (std::vector<int>{-32, -200, 32, 25}));
  EXPECT_EQ(shown({100, 9840}, {128, 100}, {0.0, 9740.0}), (std::vector<int>{-1280, 774, 12, 10}));
  EXPECT_EQ(shown({100, 984'000}, {1, 1}, {}), (std::vector<int>{-1280, -200, 1, 1}));
}

TEST(Desk, IsThatOfTheWayOfASpriteWhichCrossesBordersWhereMonitorsTouch) {
  const std::vector<Desk> monitors = {
      kMain, kLeftOfIt, {{1920, 1040}, {800, 600}, {128, 128}}, {{300, 1040}, {500, 700}, {128, 128}}};
  const Desk left_border{{-1280, 0}, {3200, 784}, {128, 128}};
  const Desk lower_border{{300, 0}, {500, 1740}, {128, 128}};
  for (const auto& [from, to, expected] : {std::tuple{Position{100, 500}, Position{0, 500}, kMain},
                                           {{0, 500}, {-1, 500}, left_border},
                                           {{10, 500}, {-300, 700}, left_border},
                                           {{0, 700}, {-1, 700}, kMain},
                                           {{-5, 500}, {10, 500}, left_border},
                                           {{-128, 500}, {-150, 500}, kLeftOfIt},
                                           {{5, 650}, {-30, 670}, left_border},
                                           {{1792, 912}, {1900, 1000}, kMain},
                                           {{400, 912}, {400, 913}, lower_border},
                                           {{299, 912}, {299, 930}, kMain},
                                           {{672, 1000}, {672, 900}, lower_border},
                                           {{5, -5}, {0, 0}, kMain},
                                           {{500, -1}, {500, 5}, kMain}}) {
    const Desk found = desk_of_way(monitors, kMain, from, to);
    EXPECT_EQ(found, expected) << from.x_px << " " << from.y_px << " to " << to.x_px << ": "
                               << found.origin.x_px << " " << found.work_area.width_px;
  }
  EXPECT_TRUE(is_one_of(monitors, kLeftOfIt) && is_one_of(monitors, left_border));
  EXPECT_FALSE(is_one_of({kMain}, left_border));
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

constexpr std::int64_t kHandTicksPerS = 10'000'000;
constexpr std::int64_t kHandMs = kHandTicksPerS / 1000;

Hold hand_at(ScreenPoint at, std::int64_t ticks = 0) { return {kHandTicksPerS, at, ticks, {}, {}}; }

// A hand that moves by `way` every `period_ms`, `moves` times.
Hold moved_hand(ScreenPoint way, std::int64_t period_ms, int moves) {
  Hold hand = hand_at({500, 400});
  for (int move = 1; move <= moves; ++move)
    hand.move({500 + move * way.x_px, 400 + move * way.y_px}, move * period_ms * kHandMs);
  return hand;
}

TEST(Hand, GivesItsMeanVelocityOverTheLastTenthOfASecond) {
  const Hold hand = moved_hand({12, -9}, 10, 30);
  EXPECT_EQ(hand.velocity(300 * kHandMs), (Velocity{1200.0, -900.0}));
  EXPECT_EQ(hand.velocity(350 * kHandMs), (Velocity{600.0, -450.0})) << "slows down";
  EXPECT_EQ(hand.velocity(400 * kHandMs), Velocity{}) << "stopped before it let go";
  EXPECT_EQ(hand.velocity(60'000 * kHandMs), Velocity{});
  EXPECT_EQ(moved_hand({20, 0}, 10, 4).velocity(40 * kHandMs), (Velocity{2000.0, 0.0})) << "a short flick";
  EXPECT_EQ(moved_hand({40, 0}, 80, 2).velocity(160 * kHandMs), (Velocity{500.0, 0.0})) << "seldom messages";
  EXPECT_EQ(moved_hand({600, -300}, 1000, 1).velocity(1000 * kHandMs), (Velocity{600.0, -300.0}))
      << "a stall";
}

TEST(Hand, IgnoresOlderMovesAndHasDraggedForTenMillisecondsAtLeast) {
  Hold hand = hand_at({0, 0});
  hand.move({-900, 300}, 100 * kHandMs);
  for (int move = 1; move <= 10; ++move) hand.move({-900 + 5 * move, 300}, (100 + 10 * move) * kHandMs);
  EXPECT_EQ(hand.velocity(200 * kHandMs), (Velocity{500.0, 0.0}));
  hand = hand_at({0, 0}, 50);
  EXPECT_EQ(hand.velocity(50), Velocity{});
  hand.move({1, 0}, 51);
  EXPECT_EQ(hand.velocity(52), (Velocity{100.0, 0.0}));
  hand.move({30, -10}, 51);
  EXPECT_EQ(hand.velocity(51), (Velocity{3000.0, -1000.0}));
  hand = hand_at({0, 0});
  for (const auto& [x_px, ms] : {std::pair{10, 100}, {20, 50}, {30, 160}}) hand.move({x_px, 0}, ms * kHandMs);
  EXPECT_NEAR(hand.velocity(210 * kHandMs).vx_px_per_s, 250.0 / 3.0, 1e-9) << "a message of before a move";
}

}  // namespace
}  // namespace hyrax
