#include "sim/reference/margin.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "tests/unit/sim/reference/test_run.h"

namespace hyrax {
namespace {

using Shift = std::array<double, 4>;

Margin margin_of(const Scenario& scenario) {
  MarginMeter meter(scenario, inputs_of(scenario));
  meter.rows(rows_of(scenario));
  return meter.margin();
}

Scenario shifted(Scenario scenario, const Shift& by) {
  scenario.start.x_px += by[0];
  scenario.start.y_px += by[1];
  scenario.start_velocity.vx_px_per_s += by[2];
  scenario.start_velocity.vy_px_per_s += by[3];
  return scenario;
}

Shift random_shift(std::mt19937_64& random, double half_width) {
  Shift shift;
  for (double& by : shift) by = std::uniform_real_distribution<>(-half_width, half_width)(random);
  return shift;
}

Shift corner(const NearestDecision& nearest, double half_width) {
  Shift shift;
  for (std::size_t i = 0; i < shift.size(); ++i) shift[i] = nearest.towards[i] * half_width;
  return shift;
}

std::vector<std::uint8_t> contacts_of(const Scenario& scenario) { return rows_of(scenario).contact; }

Scenario with_everything() {
  Scenario scenario = fling();
  scenario.clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.1, 7};
  scenario.events = {{std::int64_t{120}, Fling{{-1500.0, -900.0}}},
                     {std::int64_t{200}, Hitch{0.2}},
                     {std::int64_t{260}, Resize{Size{1280, 720}, std::nullopt}},
                     {std::int64_t{300}, Grab{}},
                     {std::int64_t{301}, Place{{640.0, 200.0}}},
                     {std::int64_t{310}, Release{{700.0, -1200.0}}}};
  return scenario;
}

// Rounding of the run itself moves a decision by some 1e-12.
constexpr double kInside = 1.0 - 1e-6;
constexpr double kOutside = 1.0 + 1e-6;

class MarginOf : public testing::TestWithParam<int> {
 protected:
  static Scenario scenario() {
    Scenario scenario = fling();
    std::mt19937_64 random(static_cast<std::uint64_t>(GetParam()));
    if (GetParam() == 0) return scenario;
    if (GetParam() == 1) return with_everything();
    scenario.start = {std::uniform_real_distribution<>(0, 1700)(random),
                      std::uniform_real_distribution<>(0, 900)(random)};
    scenario.start_velocity = {std::uniform_real_distribution<>(-2500, 2500)(random),
                               std::uniform_real_distribution<>(-2000, 1500)(random)};
    scenario.clock.base = FixedRate{std::uniform_real_distribution<>(30, 250)(random)};
    return scenario;
  }
};

TEST_P(MarginOf, KeepsAllContactsInsideAndLosesTheNearestDecisionJustOutside) {
  const Margin margin = margin_of(scenario());
  const auto contacts = contacts_of(scenario());
  std::mt19937_64 random(11);
  for (int i = 0; i < 1'000; ++i) {
    const Shift shift = random_shift(random, *margin.half_width * kInside);
    ASSERT_EQ(contacts_of(shifted(scenario(), shift)), contacts) << i;
  }
  EXPECT_EQ(contacts_of(shifted(scenario(), corner(*margin.nearest, *margin.half_width * kInside))),
            contacts);
  const auto after = contacts_of(shifted(scenario(), corner(*margin.nearest, *margin.half_width * kOutside)));
  const auto step = static_cast<std::size_t>(margin.nearest->step);
  EXPECT_NE(after[step], contacts[step]);
}

INSTANTIATE_TEST_SUITE_P(TenFlings, MarginOf, testing::Range(0, 10));

TEST(Margin, GivesTheSensitivityOfTheEnd) {
  const Scenario scenario = with_everything();
  const Margin margin = margin_of(scenario);
  const Row end = rows_of(scenario).row(600);
  const std::array<double, 4> at = {end.x_px, end.y_px, end.vx_px_per_s, end.vy_px_per_s};
  for (std::size_t start = 0; start < 4; ++start) {
    Shift shift{};
    shift[start] = *margin.half_width / 2;
    const Columns rows = rows_of(shifted(scenario, shift));
    const Row moved = rows.row(600);
    const std::array<double, 4> to = {moved.x_px, moved.y_px, moved.vx_px_per_s, moved.vy_px_per_s};
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(to[i] - at[i], margin.sensitivity[i][start] * shift[start], 1e-10) << i << " by " << start;
  }
}

Scenario one_frame(double rate_hz, const Position& start, const Velocity& velocity) {
  Scenario scenario = fling_at(rate_hz, 1);
  scenario.start = start;
  scenario.start_velocity = velocity;
  return scenario;
}

TEST(Margin, OfAFlightIsItsDistanceFromTheWallsByTheTimesOfTheRows) {
  const Margin margin = margin_of(one_frame(60.0, {896.0, 300.0}, {}));
  // After one frame y = 300 + 0.333; the top is 300.333 px away, and y moves by dy + a h dvy.
  const double h = 1.0 / 60.0;
  const double y = 300.0 + 0.999 * 1200.0 * h * h;
  EXPECT_NEAR(*margin.half_width, y / (1.0 + 0.999 * h), 1e-9);
  EXPECT_EQ(margin.nearest->decision, Decision::top);
  EXPECT_FALSE(margin.nearest->is_taken);
  EXPECT_EQ(margin.nearest->towards, (std::array<double, 4>{0.0, -1.0, 0.0, -1.0}));
  EXPECT_NEAR(margin.sensitivity_norm, 1.0 + 0.999 * h, 1e-12);
}

TEST(Margin, NamesTheRestRuleWhereItDecides) {
  // One frame at 240 Hz onto the floor, at 8.34 px/s: 0.6 of it is 5.004, just above the threshold.
  const Margin margin = margin_of(one_frame(240.0, {896.0, 952.0}, {0.0, 8.34 / 0.999 - 5.0}));
  EXPECT_EQ(margin.nearest->decision, Decision::rest);
  EXPECT_FALSE(margin.nearest->is_taken);
  EXPECT_NEAR(*margin.half_width, 0.004 / (0.6 * 0.999), 1e-9);
}

TEST(Margin, IsNoneWhereNoDecisionDependsOnTheStart) {
  Scenario scenario = open_sky({300.0, -500.0}, 60.0, 30);
  scenario.events = {{std::int64_t{0}, Place{{7000.0, 8000.0}}}, {std::int64_t{0}, Fling{{0.0, 0.0}}}};
  const Margin margin = margin_of(scenario);
  EXPECT_FALSE(margin.half_width);
  EXPECT_FALSE(margin.nearest);
  EXPECT_EQ(margin.sensitivity_norm, 0.0);
}

// A sprite that was placed on the floor, and stopped, decides on the very edge at every step; but
// no start can change that.
TEST(Margin, IsNotLimitedByAnEdgeThatTheStartDoesNotMove) {
  Scenario scenario = fling();
  scenario.clock.base = FixedStep{0.0};
  scenario.length = std::int64_t{20};
  scenario.events = {{std::int64_t{5}, Place{{0.0, 952.0}}}, {std::int64_t{5}, Stop{}}};
  EXPECT_GT(*margin_of(scenario).half_width, 1.0);
}

// The wall clamps what comes out beyond it after rounding: half a unit in the last place of 1792.
TEST(Margin, OnTheEdgeItselfIsARounding) {
  Scenario scenario = fling();
  scenario.clock.base = FixedStep{0.0};  // Nothing moves, so every row is on the bound.
  scenario.start = {1792.0, 300.0};
  EXPECT_EQ(margin_of(scenario).half_width, 0x1p-43);
}

// From row 10 on the sprite stays in its place: each later row decides the same.
TEST(Margin, NamesTheFirstOfStepsThatDecideAlike) {
  Scenario scenario = fling();
  scenario.window = {1920, 100};
  scenario.sprite = {128, 12};
  scenario.clock.base = FixedStep{1.0 / 30.0};
  scenario.events = {{std::int64_t{10}, Stop{}}};
  for (const auto& [x_px, vx_px_per_s] :
       {std::pair{1790.86, 368002.79}, std::pair{1790.8649581224138, 367656.83139047585},
        std::pair{1790.8643896163003, 367562.0545307525}})
    for (const std::int64_t length : {11, 100, 400}) {
      scenario.start = {x_px, 12.25};
      scenario.start_velocity = {vx_px_per_s, -360244.03};
      scenario.length = length;
      EXPECT_EQ(margin_of(scenario).nearest->step, 10) << vx_px_per_s << ", " << length << " frames";
    }
}

// A speed that has shrunk below the last place of the wall's coordinate moves nothing any more; nor
// does it make the wall that it touches an edge.
TEST(Margin, IsNotLimitedByASpeedThatIsRoundedAway) {
  Scenario scenario = one_frame(1000.0, {1792.0, 128.0}, {1e-13, 0.0});
  scenario.window = {1920, 256};
  // The wall takes 1.1e-13 px, of which 1e-16 are used up; x moves by dx + a h dvx.
  EXPECT_NEAR(*margin_of(scenario).half_width, 0x1p-43, 1e-15);
}

// A wall that moves in takes a resting sprite along; then the sprite stands on it, and whatever speed is too
// small to clamp it is rounded away in each step: the speeds of many steps do not add up.
TEST(Margin, OfASpriteOnAWallIsThatOfTheFirstStepThatCanFlip) {
  Scenario scenario = fling();
  scenario.start = {1700.0, 952.0};
  scenario.start_velocity = {};
  for (std::int32_t frame = 60; frame < 72; ++frame)
    scenario.events.push_back(
        {std::int64_t{frame}, Resize{Size{1760 - 40 * (frame - 60), 1080}, std::nullopt}});
  const Margin margin = margin_of(scenario);
  EXPECT_EQ(margin.nearest->step, 73);
  EXPECT_NEAR(*margin.half_width, 0.0320, 5e-5);
  const auto contacts = contacts_of(scenario);
  EXPECT_EQ(contacts_of(shifted(scenario, corner(*margin.nearest, *margin.half_width * kInside))), contacts);
  EXPECT_NE(contacts_of(shifted(scenario, corner(*margin.nearest, *margin.half_width * kOutside))), contacts);
}

}  // namespace
}  // namespace hyrax
