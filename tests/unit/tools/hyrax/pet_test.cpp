// The hyrax on a desk: hand, clock, screen and sleep.
#include "tools/hyrax/pet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {
namespace {

constexpr std::int64_t kTicksPerS = 10'000'000;
constexpr std::int64_t kMs = kTicksPerS / 1000;
constexpr std::int64_t kFrame = kTicksPerS / 60;
constexpr Desk kDesk{{100, 50}, {1024, 768}, {128, 128}};

// A hyrax on a desk, and a clock that the test controls.
class PetOnADesk : public testing::Test {
 protected:
  void frames(int count, std::int64_t frame_ticks = kFrame) {
    for (int frame = 0; frame < count; ++frame) pet.frame(ticks += frame_ticks);
  }
  void sleep() {
    for (int frame = 0; frame < 10'000 && !pet.is_asleep(); ++frame) frames(1);
    ASSERT_TRUE(pet.is_asleep());
  }
  // A hand that drags by 12 px to the right and 9 px up every 10 ms.
  void drag_away(int moves) {
    for (int move = 1; move <= moves; ++move) {
      ticks += 10 * kMs;
      hand = {hand.x_px + 12, hand.y_px - 9};
      pet.drag(hand, ticks);
      if (move % 2 == 0) pet.frame(ticks);
    }
  }
  void grab() {
    hand = {pet.place().x_px + 64, pet.place().y_px + 64};
    pet.grab(hand, ticks);
  }
  const Row& row() const { return pet.session().now().row; }
  Velocity velocity() const { return {row().vx_px_per_s, row().vy_px_per_s}; }

  // After every test: the shown frames replay to the same bits.
  void TearDown() override {
    const Tape tape = pet.session().just_happened();
    if (tape.frames() == 0) return;
    const Scenario read = parse_scenario(scenario_file_text(tape.scenario("pet")), "pet");
    EXPECT_EQ(hex(replay(shipped_core(), read).state_hash), hex(tape.state_hash()));
  }

  std::int64_t ticks = 77;
  ScreenPoint hand;
  Pet pet{shipped_core(), kDesk, kTicksPerS, ticks};
};

TEST_F(PetOnADesk, FallsFromTheMiddleOfTheTopByTheTimeThatPassed) {
  EXPECT_EQ(pet.place(), (ScreenPoint{100 + 448, 50}));
  frames(30);
  EXPECT_GT(row().y_px, 100.0);
  EXPECT_TRUE(same_bits(row().x_px, 448.0));
  for (const auto& [frame_ticks, dt_s] : {std::pair{5 * kMs, 0.005},
                                          {3 * kTicksPerS, 3.0},  // The program was stopped.
                                          {-5 * kMs, 0.0}}) {
    frames(1, frame_ticks);
    EXPECT_TRUE(same_bits(row().dt_s, dt_s)) << frame_ticks;
  }
}

TEST_F(PetOnADesk, IsOnlyDampedAndDoesNotSleepInTheAirWhileTheClockIsStopped) {
  frames(5);
  const Row before = row();
  frames(1, 0);
  EXPECT_TRUE(same_bits(row().dt_s, 0.0));
  EXPECT_TRUE(same_bits(row().y_px, before.y_px));
  EXPECT_TRUE(same_bits(row().vy_px_per_s, before.vy_px_per_s * 0.999));
  frames(10 * Session::kStillFrames, 0);
  EXPECT_FALSE(pet.is_asleep());
}

TEST_F(PetOnADesk, FollowsTheHandAndFliesAsFastAsItWhenItIsLetGo) {
  frames(10);
  const ScreenPoint before = pet.place();
  grab();
  drag_away(10);
  EXPECT_EQ(pet.place(), (ScreenPoint{before.x_px + 120, before.y_px - 90}));
  EXPECT_EQ(pet.pose(), Pose::held);
  drag_away(19);  // The last of it no frame has shown, and no message the way to where it is let go.
  pet.let_go({hand.x_px + 12, hand.y_px - 9}, ticks += 10 * kMs, kDesk);
  EXPECT_EQ(velocity(), (Velocity{1200.0, -900.0}));
  EXPECT_EQ(pet.place(), (ScreenPoint{before.x_px + 360, before.y_px - 270}));
  EXPECT_FALSE(pet.is_held());
  frames(1, 4 * kMs);
  EXPECT_TRUE(same_bits(row().dt_s, 0.004)) << "its flight begins when it is let go";
}

TEST_F(PetOnADesk, IsLetGoWithinOneFrameOrDropsWhenTheHandIsTakenAway) {
  frames(10);
  grab();
  pet.let_go(hand, ticks, kDesk);
  frames(1);
  EXPECT_EQ(pet.inputs_of_frame(), (std::vector<Action>{Grab{}, Release{}}));
  pet.reset(ticks);
  grab();
  drag_away(11);  // The last of it no frame has shown.
  pet.drop(ticks);
  EXPECT_EQ(row().x_px, hand.x_px - 64 - kDesk.origin.x_px);
  EXPECT_EQ(row().y_px, hand.y_px - 64 - kDesk.origin.y_px);
  EXPECT_EQ(velocity(), Velocity{});
  frames(20);
  EXPECT_GT(row().vy_px_per_s, 0.0);
}

TEST_F(PetOnADesk, SleepsOrIsPausedAndWakesToAFrameThatDoesNotHoldTheNight) {
  Desk other = kDesk;
  other.origin.x_px += 10;
  std::vector<std::function<void()>> inputs;
  inputs.emplace_back([&] { pet.fling({500.0, -500.0}, ticks); });
  inputs.emplace_back([&] { pet.reset(ticks); });
  inputs.emplace_back([&] { grab(); });
  inputs.emplace_back([&] { pet.drag({hand.x_px + 1, hand.y_px}, ticks); });
  inputs.emplace_back([&] { pet.drop(ticks); });
  inputs.emplace_back([&] { pet.move_to(other, ticks); });
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    sleep();
    EXPECT_EQ(pet.pose(), pet.is_held() ? Pose::held : Pose::sleep);
    if (!pet.is_held() && input % 2 == 1) pet.pause();
    const std::int64_t step = row().step;
    frames(100);
    EXPECT_EQ(row().step, step);
    ticks += 3600 * kTicksPerS;
    inputs[input]();
    EXPECT_FALSE(pet.is_paused());
    frames(1);
    EXPECT_TRUE(same_bits(row().dt_s, static_cast<double>(kFrame) / kTicksPerS)) << input;
  }
}

TEST_F(PetOnADesk, SleepsInAHandThatDoesNotMove) {
  frames(10);
  grab();
  drag_away(10);
  frames(Session::kStillFrames - 2);  // The last frame of the drag counts: it moved before it.
  EXPECT_FALSE(pet.is_asleep());
  frames(1);
  pet.drag(hand, ticks);
  EXPECT_TRUE(pet.is_asleep());
  drag_away(2);
  EXPECT_FALSE(pet.is_asleep());
  pet.let_go(hand, ticks, kDesk);
  frames(10);
}

TEST_F(PetOnADesk, IsResetToItsFirstPosition) {
  Desk wider = kDesk;
  wider.work_area.width_px += 1;
  pet.move_to(wider, ticks);
  frames(100);
  grab();
  pet.reset(ticks);
  EXPECT_FALSE(pet.is_held());
  EXPECT_TRUE(same_bits(row().x_px, 448.5) && same_bits(row().y_px, 0.0));
  EXPECT_EQ(velocity(), Velocity{});
  frames(10);
}

TEST_F(PetOnADesk, IsPushedUpByAWorkAreaThatShrinksAndFallsOnWhenItGrows) {
  sleep();
  Desk desk = kDesk;
  desk.work_area.height_px = 600;
  pet.move_to(desk, ticks += kTicksPerS);
  EXPECT_FALSE(pet.is_asleep());
  frames(1);
  EXPECT_TRUE(same_bits(row().y_px, 600.0 - 128.0));
  EXPECT_EQ(pet.inputs_of_frame(), (std::vector<Action>{Resize{Size{1024, 600}, {}}}));
  sleep();
  desk.work_area.height_px = 1000;
  pet.move_to(desk, ticks += kTicksPerS);
  frames(200);
  EXPECT_TRUE(same_bits(row().y_px, 1000.0 - 128.0));
  desk.work_area = {100, 90};  // Smaller than itself.
  pet.move_to(desk, ticks);
  frames(200);
  EXPECT_TRUE(std::isfinite(row().x_px) && std::isfinite(row().vx_px_per_s));
}

TEST_F(PetOnADesk, KeepsItsPlaceOnTheScreenWhenTheDeskMovesUnderItOrItChangesTheMonitor) {
  const Desk other{{-1280, -300}, {1280, 984}, {192, 192}};
  frames(10);
  grab();
  drag_away(4);
  ScreenPoint before = pet.place();
  Desk moved = kDesk;
  moved.origin = {140, 90};
  pet.move_to(moved, ticks);
  EXPECT_EQ(pet.place(), before);
  drag_away(2);
  EXPECT_EQ(pet.place(), (ScreenPoint{before.x_px + 24, before.y_px - 18}));
  hand = {-600, 100};
  pet.drag(hand, ticks += 10 * kMs);
  frames(1);
  before = pet.place();
  pet.let_go(hand, ticks += 10 * kMs, other);
  EXPECT_EQ(pet.place(), before);
  EXPECT_EQ(pet.session().now().window, (Size{1280, 984}));
  EXPECT_EQ(pet.session().now().sprite, (Size{192, 192}));
  frames(300);
  EXPECT_LE(row().y_px, 984.0 - 192.0);
}

TEST_F(PetOnADesk, LooksWhereItFliesUnlessItIsSlow) {
  for (const auto& [vx_px_per_s, faces_left] :
       {std::pair{-20.0, false}, {-20.1, true}, {20.0, true}, {20.1, false}}) {
    pet.fling({vx_px_per_s, -500.0}, ticks);
    frames(1);
    EXPECT_EQ(pet.faces_left(), faces_left) << vx_px_per_s;
  }
}

TEST_F(PetOnADesk, StandsFromTheThirdFrameOnTheGroundUntilItSleeps) {
  int down = 0;
  int bounces = 0;
  while (!pet.is_asleep()) {
    frames(1);
    const int before = std::exchange(down, row().y_px > 640.0 - 1.0 ? down + 1 : 0);
    bounces += down == 0 && before > 0 && before < 3;
    ASSERT_EQ(pet.pose(), pet.is_asleep() ? Pose::sleep : down >= 3 ? Pose::stand : Pose::fly) << row().step;
  }
  EXPECT_GT(bounces, 2);
}

}  // namespace
}  // namespace hyrax
