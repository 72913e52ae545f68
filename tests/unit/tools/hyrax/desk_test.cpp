// The part of the screen that the hyrax lives in.
#include "tools/hyrax/desk.h"

#include <gtest/gtest.h>

#include <limits>

namespace hyrax {
namespace {

constexpr Desk kMain{{0, 0}, {1920, 1040}, {128, 128}};
constexpr Desk kLeftOfIt{{-1280, -200}, {1280, 984}, {160, 160}};

TEST(Desk, PutsAPositionOntoTheScreen) {
  EXPECT_EQ(on_screen(kMain, {100.4, 200.5}), (ScreenPoint{100, 201}));
  EXPECT_EQ(on_screen(kLeftOfIt, {0.0, 0.0}), (ScreenPoint{-1280, -200}));
  EXPECT_EQ(on_screen(kLeftOfIt, {-0.6, 10.0}), (ScreenPoint{-1281, -190}));
}

TEST(Desk, PutsAPositionFarOutsideWhereTheScreenEnds) {
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

TEST(Desk, WithoutChangesNeedsNoInput) { EXPECT_TRUE(inputs_of_move(kMain, kMain, {5.0, 5.0}).empty()); }

TEST(Desk, OfAnotherSizeIsAResize) {
  Desk smaller = kMain;
  smaller.work_area.height_px = 600;
  const std::vector<Action> inputs = inputs_of_move(kMain, smaller, {5.0, 5.0});
  EXPECT_EQ(inputs, (std::vector<Action>{Resize{Size{1920, 600}, {}}}));
}

TEST(Desk, OfAnotherScalingResizesOnlyTheSprite) {
  Desk sharper = kMain;
  sharper.sprite = {192, 192};
  EXPECT_EQ(inputs_of_move(kMain, sharper, {5.0, 5.0}), (std::vector<Action>{Resize{{}, Size{192, 192}}}));
}

TEST(Desk, ElsewhereKeepsThePointOfTheScreen) {
  const std::vector<Action> inputs = inputs_of_move(kMain, kLeftOfIt, {-300.25, 10.5});
  const std::vector<Action> expected = {Resize{Size{1280, 984}, Size{160, 160}}, Place{{979.75, 210.5}}};
  EXPECT_EQ(inputs, expected);
  EXPECT_EQ(on_screen(kMain, {-300.25, 10.5}), on_screen(kLeftOfIt, {979.75, 210.5}));
}

TEST(Desk, WhoseTaskBarMovesToTheTopMovesOnlyItsOrigin) {
  Desk below = kMain;
  below.origin.y_px = 40;
  EXPECT_EQ(inputs_of_move(kMain, below, {5.0, 100.0}), (std::vector<Action>{Place{{5.0, 60.0}}}));
}

}  // namespace
}  // namespace hyrax
