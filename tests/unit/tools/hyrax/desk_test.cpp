#include "tools/hyrax/desk.h"

#include <gtest/gtest.h>

#include <limits>

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

}  // namespace
}  // namespace hyrax
