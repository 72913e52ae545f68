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
  // The only desk becomes this one.
  void change_to(const Desk& desk, std::int64_t after_ticks = 0) {
    pet.use_monitors({desk}, desk, ticks += after_ticks);
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
                                          {3 * kTicksPerS, 0.1},  // The program was stopped.
                                          {100 * kMs, 0.1},
                                          {-5 * kMs, 0.0}}) {
    frames(1, frame_ticks);
    EXPECT_TRUE(same_bits(row().dt_s, dt_s)) << frame_ticks;
  }
}

TEST_F(PetOnADesk, IsNotLaunchedByAStall) {
  sleep();
  change_to({kDesk.origin, {1024, 768}, {128, 127}});  // It falls by one pixel, and stands.
  frames(30);
  for (const std::int64_t stall_ms : {500, 2000, 60'000}) {
    frames(1, stall_ms * kMs);
    frames(1);
    EXPECT_GT(row().y_px, 641.0 - 5.0) << stall_ms;
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
  frames(50);
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
  frames(30);
  grab();
  drag_away(11);  // The last of it no frame has shown.
  pet.drop(ticks);
  EXPECT_EQ(row().x_px, hand.x_px - 64 - kDesk.origin.x_px);
  EXPECT_EQ(pet.place().y_px, hand.y_px - 64);
  EXPECT_EQ(velocity(), Velocity{});
  frames(20);
  EXPECT_GT(row().vy_px_per_s, 0.0);
}

TEST_F(PetOnADesk, IsBackWhereItWasGrabbedWhenTheDragIsCancelled) {
  frames(30);
  const double y_px = row().y_px;
  grab();
  drag_away(60);
  Desk moved = kDesk;
  moved.origin.x_px -= 30;
  change_to(moved);
  pet.cancel(ticks);
  EXPECT_FALSE(pet.is_held());
  EXPECT_TRUE(row().x_px == 448.0 + 30.0 && row().y_px == y_px && velocity() == Velocity{});
  frames(5);
}

TEST_F(PetOnADesk, FliesFromTheEdgeThatItWasDraggedPast) {
  frames(50);
  for (const int side : {1, -1}) {
    const double y_px = row().y_px;
    grab();
    for (const int way_px : {900 * side, 900 * side, -55 * side, -55 * side, -55 * side})
      pet.drag(hand = {hand.x_px + way_px, hand.y_px}, ticks += 100 * kMs);
    pet.let_go(hand, ticks, kDesk);
    EXPECT_EQ(velocity(), (Velocity{-550.0 * side, 0.0}));
    EXPECT_TRUE(row().x_px == (side > 0 ? 1024.0 - 128.0 : 0.0) && row().y_px == y_px);
    frames(1);
    EXPECT_EQ(velocity().vx_px_per_s, -550.0 * side * 0.999) << "no step takes it back to the edge";
    pet.fling({}, ticks);
  }
}

TEST_F(PetOnADesk, FliesOnToTheNextMonitorWhereTheyTouch) {
  const Desk right{{1124, -100}, {800, 900}, {192, 192}};  // Of another scaling, higher, and less far down.
  const Desk border{{100, 50}, {1824, 750}, {128, 128}};
  const Desk left{{-700, 0}, {800, 900}, {192, 192}};
  pet.use_monitors({left, right, kDesk}, kDesk, ticks);
  EXPECT_EQ(pet.desk(), kDesk);
  const auto screen_x_px = [&] { return pet.desk().origin.x_px + row().x_px; };
  const auto fly_to = [&](const Desk& desk, double vx_px_per_s) {
    for (int throws = 0; throws < 100 && pet.desk() != desk; ++throws) {
      pet.fling({vx_px_per_s, -10.0}, ticks);
      const double before_px = screen_x_px();
      frames(1);
      EXPECT_NEAR(screen_x_px() - before_px, vx_px_per_s / 60.0, 1.0) << "no wall";
    }
    EXPECT_EQ(pet.desk(), desk);
  };
  frames(40);
  fly_to(border, 600.0);
  fly_to(right, 600.0);
  EXPECT_EQ(pet.session().now().sprite, (Size{192, 192}));
  frames(1);
  EXPECT_GT(velocity().vx_px_per_s, 590.0);
  fly_to(kDesk, -3000.0);
  frames(1);
  EXPECT_LT(velocity().vx_px_per_s, -2900.0) << "nor one that its smaller picture meets";
  pet.fling({-1000.0, -300.0}, ticks);
  for (int frame = 0; frame < 100 && pet.desk() != left; ++frame) frames(1);
  EXPECT_LT(velocity().vx_px_per_s, -900.0) << "nor its larger one";
  pet.fling({1000.0, -300.0}, ticks);
  for (int frame = 0; frame < 100 && pet.desk() != kDesk; ++frame) frames(1);
  pet.reset(ticks);
  frames(20);
  fly_to(border, 600.0);
  pet.fling({}, ticks);
  sleep();
  EXPECT_EQ(row().y_px, 750.0 - 128.0);
  grab();
  pet.let_go(hand, ticks, kDesk);
  EXPECT_EQ(pet.desk(), border) << "let go on it";
  pet.use_monitors({kDesk}, kDesk, ticks);
  EXPECT_EQ(pet.desk(), kDesk) << "the other monitor is gone";
  frames(1);
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
  inputs.emplace_back([&] { change_to(other); });
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    sleep();
    EXPECT_EQ(pet.pose(), pet.is_held() ? Pose::held : Pose::sleep);
    if (!pet.is_held() && input % 2 == 1) pet.pause();
    const std::int64_t step = row().step;
    frames(100);
    EXPECT_EQ(row().step, step);
    ticks += 3600 * kTicksPerS;
    inputs[input]();
    EXPECT_FALSE(pet.is_paused() && input != 5) << "a pause survives a change of the display";
    pet.resume(ticks);
    frames(1);
    EXPECT_TRUE(same_bits(row().dt_s, static_cast<double>(kFrame) / kTicksPerS)) << input;
  }
}

TEST_F(PetOnADesk, IsShownOnADeskThatShrinksWhileItIsPaused) {
  sleep();
  pet.pause();
  change_to({kDesk.origin, {500, 400}, {128, 128}});
  EXPECT_TRUE(pet.is_paused());
  EXPECT_EQ(pet.place(), (ScreenPoint{100 + 372, 50 + 272}));
}

TEST_F(PetOnADesk, SleepsAgainAfterUnevenFrames) {
  constexpr std::int64_t kFrames_ms[] = {16, 12, 0, 10, 14, 9, 0, 12};
  for (int rest = 0; rest < 3; ++rest) {
    pet.fling({300.0 * rest, -200.0}, ticks);
    int still = 0;
    bool is_broken = false;
    for (int frame = 0; frame < 10'000 && !pet.is_asleep(); ++frame) {
      const Row before = row();
      std::int64_t ms = kFrames_ms[frame % 8];
      if (still == 30 + rest && !std::exchange(is_broken, true)) {
        frames(1, 60 * kMs);
        ms = 5;  // After a late frame a short one: it hops.
      }
      frames(1, ms * kMs);
      const bool is_in_place = row().x_px == before.x_px && row().y_px == before.y_px;
      still = is_in_place ? still + (ms > 0) : 0;
      ASSERT_EQ(pet.is_asleep(), still >= Session::kStillFrames) << rest << " " << frame;
    }
    EXPECT_TRUE(pet.is_asleep() && is_broken) << rest;
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
  change_to(wider);
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
  change_to(desk, kTicksPerS);
  EXPECT_FALSE(pet.is_asleep());
  frames(1);
  EXPECT_TRUE(same_bits(row().y_px, 600.0 - 128.0));
  EXPECT_EQ(pet.inputs_of_frame(), (std::vector<Action>{Resize{Size{1024, 600}, {}}}));
  sleep();
  desk.work_area.height_px = 1000;
  change_to(desk, kTicksPerS);
  frames(200);
  EXPECT_TRUE(same_bits(row().y_px, 1000.0 - 128.0));
  desk.work_area = {100, 90};  // Smaller than itself.
  change_to(desk);
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
  change_to(moved);
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
