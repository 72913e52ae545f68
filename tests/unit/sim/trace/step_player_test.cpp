#include "sim/trace/step_player.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "recording.h"
#include "sim/motion/step.h"
#include "sim/physics/physics.h"
#include "sim/trace/step_program.h"

namespace hyrax {
namespace {

using namespace recording;

constexpr Constants kPaper = {.gravity_px_per_s2 = physics::GRAVITY,
                              .restitution = physics::RESTITUTION,
                              .air_drag = physics::AIR_DRAG,
                              .ground_friction = physics::GROUND_FRICTION,
                              .rest_threshold_px_per_s = physics::REST_THRESHOLD};

template <class Body>
State state_after(Body body, double dt_s, const Size& window, const Size& sprite) {
  body.update(dt_s, window.width_px, window.height_px, sprite.width_px, sprite.height_px);
  return {body.x(), body.y(), body.vx(), body.vy()};
}

// Bits, contact and meetings of one step against physics::update and the listing's walls.
testing::AssertionResult plays_as_physics(const StepProgram& program, const State& from, double dt_s,
                                          const Size& window, const Size& sprite) {
  const physics core(from.x_px, from.y_px, from.vx_px_per_s, from.vy_px_per_s);
  const State expected = state_after(core, dt_s, window, sprite);
  TracedBody body(program, from);
  const TracedBody before = body;
  body.update(dt_s, window.width_px, window.height_px, sprite.width_px, sprite.height_px);
  if (!same_bits(State{body.x(), body.y(), body.vx(), body.vy()}, expected))
    return testing::AssertionFailure() << "other bits from x " << from.x_px << " y " << from.y_px << " vx "
                                       << from.vx_px_per_s << " vy " << from.vy_px_per_s << " dt " << dt_s;
  const ListingStep listing(kPaper, AllParts{}, bounds_of(window, sprite));
  State met_x = from;
  listing.fly(met_x, dt_s);
  State met_y = met_x;
  const std::uint8_t in_x = listing.meet_walls_in_x(met_y);
  State end = met_y;
  const std::uint8_t in_y = listing.meet_walls_in_y(end);
  const bool rests = in_y == static_cast<std::uint8_t>(Wall::ground) && end.vy_px_per_s == 0.0;
  if (body.contact() != (in_x | in_y | (rests ? kRestBit : 0)))
    return testing::AssertionFailure() << "contact " << int{body.contact()} << " from x " << from.x_px;
  const auto is = [](const Velocity& velocity, const State& state) {
    return velocity == Velocity{state.vx_px_per_s, state.vy_px_per_s};
  };
  for (const Wall wall : kWalls) {
    if (!touches(body.contact(), wall)) continue;
    const bool is_in_x = touches(in_x, wall);
    const WallMeeting meeting = before.meeting(wall, dt_s, window, sprite);
    const double overshoot_px = is_in_x ? met_x.x_px - end.x_px : met_x.y_px - end.y_px;
    if (meeting.overshoot_px != std::fabs(overshoot_px) || !is(meeting.before, is_in_x ? met_x : met_y) ||
        !is(meeting.after, is_in_x ? met_y : end))
      return testing::AssertionFailure() << "meeting " << meeting.before.vx_px_per_s << " "
                                         << meeting.after.vx_px_per_s << " at " << wall_index(wall);
  }
  return testing::AssertionSuccess();
}

class StepPlayer : public testing::Test {
 protected:
  std::shared_ptr<const StepProgram> program_ = make_step_program(canonical(record_listing()));
};

TEST_F(StepPlayer, GivesTheBitsOfPhysicsOverTheEdges) {
  ASSERT_TRUE(program_);
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::array speeds = {0.0, -0.0, tiny, -tiny, 5.0, 8.333333333333334, -7.495, 3000.0, -3000.0, 1e12};
  const std::array places = {0.0, -0.0, tiny, -1.0, 872.0, 872.0000000000001, 871.9999999999999, 1e12};
  for (const double x : places)
    for (const double y : places)
      for (const double vx : speeds)
        for (const double vy : speeds)
          for (const double dt_s : {0.0, 1.0 / 60.0, 0.5})
            for (const Size& sprite : {Size{128, 128}, Size{1500, 1000}})
              ASSERT_TRUE(plays_as_physics(*program_, {x, y, vx, vy}, dt_s, {1000, 1000}, sprite));
}

TEST_F(StepPlayer, GivesTheBitsOfPhysicsInRandomSteps) {
  std::mt19937_64 random(7);
  const auto drawn = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  for (int turn = 0; turn < 100'000; ++turn) {
    const Size window = {static_cast<int>(drawn(0, 4000)), static_cast<int>(drawn(0, 3000))};
    const Size sprite = {static_cast<int>(drawn(1, 300)), static_cast<int>(drawn(1, 300))};
    const State from = {drawn(-10, window.width_px), drawn(-10, window.height_px),
                        drawn(-1, 1) * std::exp(drawn(-5, 12)), drawn(-1, 1) * std::exp(drawn(-5, 12))};
    ASSERT_TRUE(plays_as_physics(*program_, from, std::exp(drawn(-9, 1)), window, sprite));
    const State bits = {std::bit_cast<double>(random()), std::bit_cast<double>(random()),
                        std::bit_cast<double>(random()), std::bit_cast<double>(random())};
    if (is_finite(bits)) {
      const State after = state_after(physics(bits.x_px, bits.y_px, bits.vx_px_per_s, bits.vy_px_per_s), 0.01,
                                      window, sprite);
      if (is_finite(after)) {
        ASSERT_TRUE(same_bits(state_after(TracedBody(*program_, bits), 0.01, window, sprite), after));
      }
    }
  }
}

// One update of a body at (x, y, vx, vy) in a window of 1000 x 1000, the sprite 100 x 100.
State once(const Update& update, const State& from, int window_width_px = 1000) {
  const auto program = make_step_program(canonical(record(update)));
  return state_after(TracedBody(*program, from), 0.25, {window_width_px, 1000}, {100, 100});
}

TEST(StepPlayerOfOtherKinds, CalculatesIntsAsIntsWithoutUndefinedResults) {
  const auto update = [](Body& body, const Frame& frame) {
    body.x = to_real(frame.window_width / Whole(3));
    body.y = to_real(frame.window_width % Whole(3));
    body.vx = to_real(frame.window_width * Whole(2147483647.0));
    body.vy = to_real(to_whole(body.vy) / (frame.sprite_width - frame.sprite_height));
  };
  const State after = once(update, {0, 0, 0, -7.9}, 200);
  EXPECT_EQ(after.x_px, 66.0);
  EXPECT_EQ(after.y_px, 2.0);
  EXPECT_EQ(after.vx_px_per_s, -200.0);
  EXPECT_EQ(after.vy_px_per_s, 0.0);
  const auto whole = [](Body& body, const Frame& frame) {
    body.x = to_real(to_whole(body.x) / (frame.window_width - Whole(1001)));
    body.y = to_real(to_whole(body.y) % (frame.window_width - Whole(1001)));
    body.vx = to_real(-to_whole(body.vx));
  };
  const State least = once(whole, {-2147483648.0, -2147483648.0, 1e300, 0});
  EXPECT_EQ(least.x_px, -2147483648.0);
  EXPECT_TRUE(same_bits(least.y_px, 0.0));
  EXPECT_EQ(least.vx_px_per_s, -2147483648.0);
}

TEST(StepPlayerOfOtherKinds, CalculatesFloatsAsFloats) {
  const auto update = [](Body& body, const Frame& frame) {
    body.x = to_real(to_single(body.x) + to_single(body.vx) * to_single(frame.dt));
    body.y = sqrt(body.y);
    body.vy = fma(body.vx, body.vx, body.vy);
  };
  const float x = 0.1f + 0.3f * 0.25f;
  const State after = once(update, {0.1, 2.0, 0.3, -0.09});
  EXPECT_EQ(after.x_px, static_cast<double>(x));
  EXPECT_EQ(after.y_px, std::sqrt(2.0));
  EXPECT_EQ(after.vy_px_per_s, std::fma(0.3, 0.3, -0.09));
}

TEST(StepPlayerOfOtherKinds, SaysWhatItCannotPlay) {
  EXPECT_EQ(make_step_program(canonical(record([](Body& body, const Frame&) {
              body.x = Real::of(trace::record_call("lgamma", NumberKind::real, body.x.index()));
            }))),
            nullptr);
  TracedStep cut = canonical(record_listing());
  cut.paths[1].pop_back();
  EXPECT_EQ(make_step_program(cut), nullptr);
}

}  // namespace
}  // namespace hyrax
