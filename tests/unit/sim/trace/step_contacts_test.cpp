// Contacts of cores of one's own: what counters in their wall branches say, a traced step says, too.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "recording.h"
#include "sim/trace/step_player.h"
#include "sim/trace/step_program.h"

namespace hyrax {
namespace {

// Each core is written once, for doubles that move and for numbers that record.
struct MovingBody {
  double x = 0.0, y = 0.0, vx = 0.0, vy = 0.0;
};
struct MovingFrame {
  double dt = 0.0;
  int window_width = 0, window_height = 0, sprite_width = 0, sprite_height = 0;
};
double to_real(int a) { return a; }
double to_real(float a) { return static_cast<double>(a); }
float to_single(double a) { return static_cast<float>(a); }
using recording::to_real;
using recording::to_single;
using std::fabs;
using std::fma;
using std::pow;

// The counters: what the branches of the present step did.
struct Met {
  std::optional<Velocity> before;
};
std::array<Met, 4> met;
void meet(Wall wall, double vx, double vy) {
  Met& now = met[wall_index(wall)];
  if (!now.before) now.before = {vx, vy};
}
void meet(Wall, const recording::Real&, const recording::Real&) {}

auto right_of(const auto& f) { return to_real(f.window_width - f.sprite_width); }
auto bottom_of(const auto& f) { return to_real(f.window_height - f.sprite_height); }

// Turns a body around at a wall, and puts it there.
void turn_x(auto& b, Wall wall, const auto& x, const auto& vx) {
  meet(wall, b.vx, b.vy);
  b.x = x;
  b.vx = vx;
}
void turn_y(auto& b, Wall wall, const auto& y, const auto& vy) {
  meet(wall, b.vx, b.vy);
  b.y = y;
  b.vy = vy;
}

void meet_x(auto& b, const auto& f) {
  if (b.x < 0.0)
    turn_x(b, Wall::left, 0.0, -b.vx * 0.6);
  else if (b.x > right_of(f))
    turn_x(b, Wall::right, right_of(f), -b.vx * 0.6);
}
void meet_y(auto& b, const auto& f) {
  if (b.y < 0.0) {
    turn_y(b, Wall::top, 0.0, -b.vy * 0.6);
  } else if (b.y > bottom_of(f)) {
    turn_y(b, Wall::ground, bottom_of(f), -b.vy * 0.6);
    b.vx = b.vx * 0.8;
    if (fabs(b.vy) < 5.0) b.vy = 0.0;
  }
}
void meet_walls(auto& b, const auto& f) {
  meet_x(b, f);
  meet_y(b, f);
}
void fall(auto& b, const auto& dt) { b.vy = b.vy + dt * 1200.0; }
void move(auto& b, const auto& dt) {
  b.x = b.x + b.vx * dt;
  b.y = b.y + b.vy * dt;
}
void fly(auto& b, const auto& f) {
  fall(b, f.dt);
  move(b, f.dt);
}

// Fused gravity, drag by time, and two half moves, of which one is fused.
struct OtherFlight {
  void operator()(auto& b, const auto& f) const {
    b.vy = fma(decltype(b.vy)(1200.0), f.dt, b.vy);
    const auto drag = pow(decltype(b.vx)(0.999), f.dt * 60.0);
    b.vx = b.vx * drag;
    b.vy = b.vy * drag;
    move(b, f.dt * 0.5);
    b.x = fma(b.vx, f.dt * 0.5, b.x);
    b.y = fma(b.vy, f.dt * 0.5, b.y);
    meet_walls(b, f);
  }
};
struct YFirst {
  static constexpr bool kTellsVelocity = false;  // In a corner the order in which they are met makes no bit.
  void operator()(auto& b, const auto& f) const {
    fly(b, f);
    meet_y(b, f);
    meet_x(b, f);
  }
};
struct InFloat {
  void operator()(auto& b, const auto& f) const {
    fall(b, f.dt);
    const auto x = to_single(b.x) + to_single(b.vx) * to_single(f.dt);
    b.y = to_real(to_single(b.y) + to_single(b.vy) * to_single(f.dt));
    if (x < to_single(decltype(b.x)(0.0))) {
      meet(Wall::left, b.vx, b.vy);
      b.vx = -b.vx;
    }
    if (to_single(right_of(f)) < x) {
      meet(Wall::right, b.vx, b.vy);
      b.vx = -b.vx;
    }
    b.x = to_real(x);
    meet_y(b, f);
  }
};
struct Reflected {
  void operator()(auto& b, const auto& f) const {
    fly(b, f);
    if (!(b.x >= 0.0))
      turn_x(b, Wall::left, -b.x, -b.vx);
    else if (b.x + to_real(f.sprite_width) >= to_real(f.window_width))
      turn_x(b, Wall::right, right_of(f) * 2.0 - b.x, -b.vx);
    if (b.y - bottom_of(f) > 0.0) turn_y(b, Wall::ground, bottom_of(f) * 2.0 - b.y, -b.vy * 0.9);
  }
};
struct SubSteps {
  static constexpr bool kTellsVelocity = false;
  void operator()(auto& b, const auto& f) const {
    for (int half = 0; half < 2; ++half) {
      fall(b, f.dt * 0.5);
      move(b, f.dt * 0.5);
      meet_walls(b, f);
    }
  }
};
struct WallsOnTheBoundAndAllInside {
  void operator()(auto& b, const auto& f) const {
    fly(b, f);
    if (b.x <= 0.0)
      turn_x(b, Wall::left, 0.0, fabs(b.vx));
    else if (b.x >= right_of(f))
      turn_x(b, Wall::right, right_of(f), -fabs(b.vx));
    if (!(b.y >= 0.0 && b.y <= bottom_of(f))) {
      meet(b.y < 0.0 ? Wall::top : Wall::ground, b.vx, b.vy);
      if (b.y < 0.0)
        b.y = -b.y;
      else
        b.y = bottom_of(f) * 2.0 - b.y;
      b.vy = -b.vy * 0.9;
    }
  }
};
struct NeverNegativeBoundsAndClamped {
  void operator()(auto& b, const auto& f) const {
    auto right = right_of(f);
    if (right < 0.0) right = 0.0;
    fly(b, f);
    if (b.x < 0.0) turn_x(b, Wall::left, 0.0, -b.vx);
    if (b.x > right) turn_x(b, Wall::right, right, -b.vx);
    auto inside = b.y;
    if (b.y < 0.0)
      inside = 0.0;
    else if (b.y > bottom_of(f))
      inside = bottom_of(f);
    if (!(inside == b.y)) turn_y(b, b.y < 0.0 ? Wall::top : Wall::ground, inside, -b.vy * 0.6);
  }
};

struct SnapsToTheLeft {
  void operator()(auto& b, const auto& f) const {
    fly(b, f);
    // No wall, though it asks for 0 from above.
    if (b.x > 0.0 && b.x < 30.0 && fabs(b.vx) < 2000.0) b.x = 0.0;
    meet_walls(b, f);
  }
};
struct ShelfInside {
  void operator()(auto& b, const auto& f) const {
    fly(b, f);
    if (b.y > 300.0 && b.y < 320.0 && b.x < 300.0) {
      b.y = 300.0;
      b.vy = -b.vy * 0.6;
    }
    meet_walls(b, f);
  }
};

// Rubs where it lay before the step.
struct FrictionOfTheRowBefore {
  void operator()(auto& b, const auto& f) const {
    if (b.y >= bottom_of(f)) b.vx = b.vx * 0.8;
    fly(b, f);
    meet_x(b, f);
    if (b.y > bottom_of(f)) turn_y(b, Wall::ground, bottom_of(f), -b.vy * 0.6);
  }
};
struct WallsFirst {
  static constexpr bool kTellsVelocity = false;  // What it falls with comes later.
  void operator()(auto& b, const auto& f) const {
    meet_walls(b, f);
    fly(b, f);
  }
};
struct ByTheRoomLeftAndItsMiddle {
  void operator()(auto& b, const auto& f) const {
    const auto half = to_real(f.sprite_height) * 0.5;
    fly(b, f);
    if (b.x < 0.0)
      turn_x(b, Wall::left, 0.0, -b.vx);
    else if (right_of(f) - b.x < 0.0)
      turn_x(b, Wall::right, right_of(f), -b.vx);
    if (b.y + half < half)
      turn_y(b, Wall::top, 0.0, -b.vy);
    else if (b.y + half > to_real(f.window_height) - half)
      turn_y(b, Wall::ground, bottom_of(f), -b.vy);
  }
};
// Height above the ground, and twice the position.
struct MeasuredFromTheOtherWallAndScaled {
  void operator()(auto& b, const auto& f) const {
    fly(b, f);
    if (b.x * 2.0 < 0.0)
      turn_x(b, Wall::left, 0.0, -b.vx);
    else if (b.x * 2.0 > right_of(f) * 2.0)
      turn_x(b, Wall::right, right_of(f), -b.vx);
    const auto height = bottom_of(f) - b.y;
    if (height > bottom_of(f))
      turn_y(b, Wall::top, 0.0, -b.vy);
    else if (height * -0.5 > 0.0)
      turn_y(b, Wall::ground, bottom_of(f), -b.vy * 0.6);
  }
};
// A twentieth of the window is left free; the origin is in the middle.
struct WithAMarginAndByTheMiddle {
  void operator()(auto& b, const auto& f) const {
    fly(b, f);
    const auto margin = to_real(f.window_width) * 0.05;
    if (b.x < margin)
      turn_x(b, Wall::left, margin, fabs(b.vx));
    else if (b.x > right_of(f) - margin)
      turn_x(b, Wall::right, right_of(f) - margin, -fabs(b.vx));
    const auto middle = bottom_of(f) / 2.0;
    if (b.y - middle < -middle)
      turn_y(b, Wall::top, 0.0, fabs(b.vy));
    else if (b.y - middle > middle)
      turn_y(b, Wall::ground, bottom_of(f), -fabs(b.vy));
  }
};
template <class Core>
class ContactsOf : public testing::Test {};
using Cores = testing::Types<OtherFlight, YFirst, InFloat, Reflected, SubSteps, WallsOnTheBoundAndAllInside,
                             NeverNegativeBoundsAndClamped, SnapsToTheLeft, ShelfInside,
                             FrictionOfTheRowBefore, WallsFirst, ByTheRoomLeftAndItsMiddle,
                             MeasuredFromTheOtherWallAndScaled, WithAMarginAndByTheMiddle>;
TYPED_TEST_SUITE(ContactsOf, Cores);

TYPED_TEST(ContactsOf, AreThoseOfItsCounters) {
  const auto program = make_step_program(
      canonical(recording::record([](recording::Body& b, const recording::Frame& f) { TypeParam()(b, f); })));
  ASSERT_TRUE(program);
  std::mt19937_64 random(3);
  const auto drawn = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  std::array<int, 4> contacts{};
  for (int fling = 0; fling < 60; ++fling) {
    const Size window = {fling % 10 == 0 ? 50 : 700, 600};
    const Size sprite = {100, 100};
    const State start = {drawn(0, 500), drawn(0, 500), drawn(-4000, 4000), drawn(-4000, 4000)};
    MovingBody body = {start.x_px, start.y_px, start.vx_px_per_s, start.vy_px_per_s};
    TracedBody traced(*program, start);
    for (int step = 0; step < 200; ++step) {
      const double dt_s = step % 50 == 0 ? 0.2 : 1.0 / 60.0;
      const TracedBody before = traced;
      traced.update(dt_s, window.width_px, window.height_px, sprite.width_px, sprite.height_px);
      met = {};
      TypeParam()(body,
                  MovingFrame{dt_s, window.width_px, window.height_px, sprite.width_px, sprite.height_px});
      ASSERT_TRUE(same_bits(State{traced.x(), traced.y(), traced.vx(), traced.vy()},
                            State{body.x, body.y, body.vx, body.vy}));
      for (const Wall wall : kWalls) {
        const std::optional<Velocity>& counted = met[wall_index(wall)].before;
        ASSERT_EQ(touches(traced.contact(), wall), counted.has_value()) << fling << " " << step;
        if (!counted) continue;
        ++contacts[wall_index(wall)];
        if constexpr (!requires { TypeParam::kTellsVelocity; }) {
          ASSERT_EQ(before.meeting(wall, dt_s, window, sprite).before, *counted) << fling << " " << step;
        }
      }
    }
  }
  EXPECT_GT(contacts[wall_index(Wall::left)], 60);
  EXPECT_GT(contacts[wall_index(Wall::ground)], 60);
}

TEST(ContactsOfALargeSprite, AreBeyondTheBoundByWhatThePositionWasSetTo) {
  const auto program = make_step_program(canonical(
      recording::record([](recording::Body& b, const recording::Frame& f) { SnapsToTheLeft()(b, f); })));
  ASSERT_TRUE(program);
  for (const double x : {10.0, 40.0}) {
    const TracedBody body(*program, {x, 50.0, 0.0, 0.0});
    EXPECT_EQ(body.meeting(Wall::right, 0.01, {50, 600}, {100, 100}).overshoot_px,
              x < 30.0 ? 50.0 : x + 50.0);
  }
}

TEST(ContactsOfAStep, OvershootIsInPixelsOfThePosition) {
  const auto overshoot = [](const auto& core, Wall wall, const State& start, double dt_s) {
    const auto program = make_step_program(
        canonical(recording::record([&](recording::Body& b, const recording::Frame& f) { core(b, f); })));
    return TracedBody(*program, start).meeting(wall, dt_s, {700, 600}, {100, 100}).overshoot_px;
  };
  const MeasuredFromTheOtherWallAndScaled scaled;
  EXPECT_EQ(overshoot(scaled, Wall::right, {596, 100, 64, 0}, 0.125), 4.0);
  EXPECT_EQ(overshoot(scaled, Wall::ground, {100, 504, 0, 0}, 0.0), 4.0);
  EXPECT_EQ(overshoot(scaled, Wall::top, {100, -3, 0, 0}, 0.0), 3.0);
  // Of two halves of a step both are beyond the ground, or the last one only.
  EXPECT_TRUE(std::isnan(overshoot(SubSteps(), Wall::ground, {100, 500, 0, 0}, 1.0)));
  EXPECT_EQ(overshoot(SubSteps(), Wall::right, {500, 100, 150, 0}, 1.0), 50.0);
}

}  // namespace
}  // namespace hyrax
