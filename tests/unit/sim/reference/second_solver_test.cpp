// The exact fling against a second solver, where it is hard: corners, slits, grazing, huge speeds, no losses.
#include "tests/unit/sim/reference/second_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sim/reference/enclosed_fling.h"
#include "sim/reference/exact_fling.h"
#include "sim/reference/largest.h"
#include "sim/search/draws.h"

namespace hyrax {
namespace {

constexpr Bounds kRoom{1792.0, 952.0};

struct Shot {
  State start;
  Bounds bounds = kRoom;
  SecondLaws laws = {};
  double until_s = 6.0;
};

FixedLaws laws_of(const SecondLaws& laws) {
  return FixedLaws(Model(Constants{.gravity_px_per_s2 = laws.gravity,
                                   .restitution = laws.restitution,
                                   .air_drag = laws.drag,
                                   .ground_friction = laws.friction,
                                   .rest_threshold_px_per_s = laws.threshold}));
}

double moved_by_ulps(double value, std::int64_t ulps) {
  for (; ulps != 0; ulps += ulps > 0 ? -1 : 1) value = std::nextafter(value, ulps > 0 ? HUGE_VAL : -HUGE_VAL);
  return value;
}

// From where a fling meets the corner after t with that velocity, and within a few ulp.
State aimed_at(double x, double y, double vx, double vy, double t, const SecondLaws& laws, Draws& draws) {
  const Wide rate = log(Wide(laws.drag)) * -60.0;
  WideMotion across{x, vx}, down{y, vy};
  across.fly(0.0, rate * (0.0 - Wide(t)), 0.0 - Wide(t));
  down.fly(laws.gravity, rate * (0.0 - Wide(t)), 0.0 - Wide(t));
  const auto near = [&draws](const Wide& value) {
    return moved_by_ulps(value.rounded(), static_cast<std::int64_t>(draws.below(13)) - 6);
  };
  return {near(across.displacement), near(down.displacement), near(across.speed), near(down.speed)};
}

bool is_within(const State& state, const Bounds& bounds) {
  return state.x_px >= 0.0 && state.x_px <= bounds.right_px && state.y_px >= 0.0 &&
         state.y_px <= bounds.bottom_px;
}

Shot into_a_corner(Draws& draws, const SecondLaws& laws = {}) {
  for (;;) {
    const bool is_right = draws.below(2) == 1;
    const bool is_ground = draws.below(2) == 1;
    const double vx = draws.between(20.0, 2500.0) * (is_right ? 1.0 : -1.0);
    const double vy = draws.between(20.0, 1500.0) * (is_ground ? 1.0 : -1.0);
    const State start = aimed_at(is_right ? kRoom.right_px : 0.0, is_ground ? kRoom.bottom_px : 0.0, vx, vy,
                                 draws.between(0.01, 2.0), laws, draws);
    if (is_within(start, kRoom)) return {start, kRoom, laws};
  }
}
Shot grazing(Draws& draws) {
  for (;;) {
    const State start = aimed_at(draws.between(0.0, kRoom.right_px), 0.0, draws.between(-800.0, 800.0), 0.0,
                                 draws.between(0.05, 1.0), {}, draws);
    if (is_within(start, kRoom)) return {start};
  }
}
Shot anywhere(Draws& draws, const SecondLaws& laws = {}) {
  return {{draws.between(0.0, kRoom.right_px), draws.between(0.0, kRoom.bottom_px),
           draws.between(-2500.0, 2500.0), draws.between(-2500.0, 2500.0)},
          kRoom,
          laws};
}
Shot in_a_slit(Draws& draws) {
  const double sides[] = {0.0, 1.0, 2.0, 952.0};
  Shot shot = anywhere(draws);
  shot.bounds = {sides[draws.below(4)], sides[draws.below(3)]};
  if (draws.below(2) == 1) std::swap(shot.bounds.right_px, shot.bounds.bottom_px);
  shot.start.x_px = draws.between(0.0, shot.bounds.right_px);
  shot.start.y_px = draws.between(0.0, shot.bounds.bottom_px);
  return shot;
}
// From the middle into a corner, where all that comes after meets corners again.
State towards_a_corner(double time_s) {
  return {kRoom.right_px / 2, kRoom.bottom_px / 2, kRoom.right_px / time_s, kRoom.bottom_px / time_s};
}
Shot at_huge_speed(Draws& draws) { return {towards_a_corner(draws.between(1e-8, 1e-7)), kRoom, {}, 2.0}; }

// The largest distance of both solvers, at sixty times; and whether bounds that there are hold it, and how
// wide they are.
struct Apart {
  double px = 0.0;
  double widest_px = 0.0;
  int impacts = 0;
  int undecided = 0;
};

bool holds(const Ball& ball, const Wide& value) {
  const Wide apart = value - ball.mid.hi - ball.mid.lo;
  const Wide radius = ball.radius + 1e-60;
  return !(radius < apart) && !(apart < Wide(0.0) - radius);
}

Apart apart(const std::function<Shot(Draws&)>& shots) {
  Apart apart;
  Draws draws(7);
  for (int number = 0; number < 12; ++number) {
    const Shot shot = shots(draws);
    const State& from = shot.start;
    ExactFling fling(laws_of(shot.laws));
    fling.start(from, shot.bounds);
    EnclosedFling enclosed(laws_of(shot.laws));
    enclosed.start(EnclosedState(from), shot.bounds, false);
    SecondSolver second(shot.laws, shot.bounds.right_px, shot.bounds.bottom_px, shot.until_s);
    second.start({from.x_px, from.y_px, from.vx_px_per_s, from.vy_px_per_s});
    constexpr int kRows = 60;
    for (int row = 0; row <= kRows; ++row) {
      const double t_s = shot.until_s * row / kRows;
      const State state = fling.at(t_s);
      const SecondSolver::Motion place = second.at(t_s);
      EXPECT_TRUE(fling.is_sound() && is_within(state, shot.bounds)) << t_s;
      apart.px = larger(apart.px, std::hypot(state.x_px - place.x.rounded(), state.y_px - place.y.rounded()));
      const auto bounds = enclosed.at(t_s);
      if (!bounds) continue;
      EXPECT_TRUE(holds(bounds->x_px, place.x) && holds(bounds->y_px, place.y))
          << number << " at " << t_s << " s";
      apart.widest_px = std::max({apart.widest_px, bounds->x_px.radius, bounds->y_px.radius});
    }
    apart.impacts += second.impacts();
    if (!enclosed.why_not().empty()) ++apart.undecided;
  }
  return apart;
}

// Both solve the same flings; what a touch within rounding of a wall is taken for moves a sprite that grazes
// it by the root of that.
TEST(ExactFling, IsThatOfASecondSolver) {
  SecondLaws inelastic, lossless, dragless;
  inelastic.restitution = 0.0;
  lossless.restitution = lossless.drag = lossless.friction = 1.0;
  dragless.drag = 1.0;
  const struct {
    const char* name;
    double apart_px_max;
    std::function<Shot(Draws&)> shot;
  } families[] = {
      {"anywhere", 1e-10, [](Draws& draws) { return anywhere(draws); }},
      {"into a corner", 1e-10, [](Draws& draws) { return into_a_corner(draws); }},
      {"grazing", 1e-4, grazing},
      {"in a slit", 1e-10, in_a_slit},
      {"at huge speed", 1e-10, at_huge_speed},
      {"without restitution", 1e-10, [&](Draws& draws) { return into_a_corner(draws, inelastic); }},
      {"without losses", 1e-10, [&](Draws& draws) { return into_a_corner(draws, lossless); }},
      {"without drag", 1e-10, [&](Draws& draws) { return into_a_corner(draws, dragless); }}};
  for (const auto& family : families) {
    const Apart found = apart(family.shot);
    EXPECT_LE(found.px, family.apart_px_max) << family.name;
    EXPECT_LE(found.widest_px, 1e-9) << family.name;
    EXPECT_EQ(found.undecided, 0) << family.name;
    EXPECT_GE(found.impacts, 24) << family.name;
  }
}

TEST(ExactFling, StaysInsideFromEveryCorner) {
  Draws draws(3);
  for (int number = 0; number < 4000; ++number)
    for (const Shot& shot : {into_a_corner(draws), at_huge_speed(draws)}) {
      ExactFling fling;
      fling.start(shot.start, shot.bounds);
      const State end = fling.at(10.0);
      ASSERT_TRUE(fling.is_sound()) << number;
      ASSERT_TRUE(fling.slides()) << number;
      ASSERT_EQ(end.y_px, kRoom.bottom_px) << number;
    }
}

// It meets the walls of a slit for ever.
TEST(ExactFling, WithoutLossesIsCutAfterAMillionImpacts) {
  SecondLaws lossless;
  lossless.restitution = lossless.drag = lossless.friction = 1.0;
  ExactFling fling(laws_of(lossless));
  fling.start({0.5, 0.0, 1e9, 0.0}, {1.0, 500.0});
  EXPECT_TRUE(is_within(fling.at(1.0), {1.0, 500.0}));
  EXPECT_TRUE(fling.is_cut() && fling.is_sound());
}

}  // namespace
}  // namespace hyrax
