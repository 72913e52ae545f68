// Contacts by cores that do not tell them: of rows, and by a traced step. Those of the shipped core are the
// shipped ones.
#include "sim/core/core.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim/core/contact_stepper.h"
#include "sim/core/core_record.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/core/stepper_of.h"
#include "sim/core/traced_stepper.h"
#include "sim/replay/replay.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/sim/trace/recording.h"

namespace hyrax {
namespace {

constexpr Bounds kBounds{1000.0, 500.0};
constexpr double kDt_s = 0.1;
constexpr State kInside{500.0, 250.0, 0.0, 0.0};

std::uint8_t bit(Wall wall) { return static_cast<std::uint8_t>(wall); }

TEST(RowWalls, AreMetOnOrPastABoundOrWhereTheVelocityTurnsAwayWithinReach) {
  const struct {
    State before, after;
    int contact;
  } cases[] = {
      {kInside, {0.0, 250.0, -9.0, 0.0}, bit(Wall::left)},
      {kInside, {-1e-9, 250.0, 9.0, 0.0}, bit(Wall::left)},
      {kInside, {1000.0, 250.0, 9.0, 0.0}, bit(Wall::right)},
      {kInside, {500.0, -3.0, 0.0, 9.0}, bit(Wall::top)},
      {kInside, {500.0, 501.0, 0.0, 9.0}, bit(Wall::ground)},
      {kInside, {0.0, 500.0, 9.0, 9.0}, bit(Wall::left) | bit(Wall::ground)},
      {kInside, {1e-9, std::nextafter(500.0, 0.0), 9.0, 9.0}, 0},
      {{4.0, 250.0, -50.0, 0.0}, {1.0, 250.0, 50.0, 0.0}, bit(Wall::left)},
      {{998.0, 250.0, 50.0, 0.0}, {997.0, 250.0, -50.0, 0.0}, bit(Wall::right)},
      {{500.0, 4.0, 0.0, -50.0}, {500.0, 1.0, 0.0, 50.0}, bit(Wall::top)},
      {{500.0, 498.0, 0.0, 50.0}, {500.0, 497.0, 0.0, -50.0}, bit(Wall::ground)},
      // Neither at an apex nor by a weakened velocity.
      {{500.0, 6.0, 0.0, -50.0}, {500.0, 5.0, 0.0, 50.0}, 0},
      {{500.0, 250.0, 30.0, 50.0}, {500.0, 250.0, -30.0, -50.0}, 0},
      {{4.0, 250.0, -50.0, 0.0}, {1.0, 250.0, -10.0, 0.0}, 0},
      {{4.0, 250.0, -50.0, 0.0}, {1.0, 250.0, 0.0, 0.0}, 0},
      // The rest bit is set on the ground only.
      {kInside, {500.0, 500.0, 9.0, 0.0}, bit(Wall::ground) | kRestBit},
      {kInside, {500.0, 0.0, 9.0, 0.0}, bit(Wall::top)},
  };
  for (const auto& [before, after, contact] : cases)
    EXPECT_EQ(contact_of_rows(kBounds, before, kDt_s, after), contact) << after.x_px << ", " << after.y_px;
  EXPECT_EQ(contact_of_rows({0.0, -20.0}, kInside, kDt_s, {0.0, -10.0, 1.0, 1.0}),
            bit(Wall::left) | bit(Wall::top))
      << "of two at the same place";
}

// Gravity, and walls that reflect the path.
struct ReflectedStep {
  void operator()(State& s, double dt_s, const Bounds& bounds) const {
    s.vy_px_per_s += 1200.0 * dt_s;
    s.x_px += s.vx_px_per_s * dt_s;
    s.y_px += s.vy_px_per_s * dt_s;
    reflect(s.x_px, s.vx_px_per_s, bounds.right_px);
    reflect(s.y_px, s.vy_px_per_s, bounds.bottom_px);
  }
  static void reflect(double& at_px, double& v_px_per_s, double bound_px) {
    if (at_px >= 0.0 && at_px <= bound_px) return;
    at_px = (at_px < 0.0 ? 0.0 : 2.0 * bound_px) - at_px;
    v_px_per_s *= -0.9;
  }
};

TEST(StepperOfARowCore, GivesTheContactsOfItsRows) {
  const Core reflected{
      .stepper = std::make_shared<const ContactStepper>(
          std::make_shared<const StepperOf<StepCores<ReflectedStep>>>(), nullptr, std::nullopt)};
  Scenario scenario = fling_at(60.0, 600);
  scenario.start = {301.25, 500.5};  // No row is on a bound.
  TraceSink trace;
  const RunSummary summary = replay(reflected, scenario, trace);
  const Bounds bounds = bounds_of(scenario.window, scenario.sprite);
  for (std::size_t step = 1; step <= 600; ++step) {
    const Row &before = trace.rows()[step - 1], &after = trace.rows()[step];
    ASSERT_EQ(after.contact, contact_of_rows(bounds, state_of(before), after.dt_s, state_of(after))) << step;
  }
  ASSERT_GE(trace.contacts().size(), 6u);
  for (const Contact& contact : trace.contacts()) {
    const auto step = static_cast<std::size_t>(contact.step);
    const State before = state_of(trace.rows()[step - 1]);
    EXPECT_TRUE(std::isnan(contact.overshoot_px));
    EXPECT_TRUE(same_bits({contact.x_px, contact.y_px, contact.vx_after_px_per_s, contact.vy_after_px_per_s},
                          state_of(trace.rows()[step])));
    EXPECT_EQ(contact.vx_before_px_per_s, before.vx_px_per_s);
    EXPECT_EQ(contact.vy_before_px_per_s, before.vy_px_per_s);
  }
  EXPECT_EQ(summary.contacts.top, 0);
  EXPECT_TRUE(summary.had_friction);
}

void expect_the_runs_of_the_shipped_core(const Core& core) {
  for (const std::string& path : scenario_files()) {
    const Scenario scenario = load_scenario(path);
    TraceSink shipped({.rows_every = 1000, .contacts = true, .blocks = true});
    TraceSink played({.rows_every = 1000, .contacts = true, .blocks = true});
    const std::string expected = text_of(replay(shipped_core(), scenario, shipped));
    ASSERT_EQ(text_of(replay(core, scenario, played)), expected) << path;
    ASSERT_TRUE(same_trace(played, shipped)) << path;
  }
}

// The shipped rows, their contacts told by this step, or without one by the rows.
TEST(ContactStepper, TellsTheContactsOfTheCoreByItsTracedStepAndByRowsThatAreThePapers) {
  for (const auto& step :
       {make_step_program(canonical(recording::record_listing())), std::shared_ptr<const StepProgram>()}) {
    Core core = shipped_core();
    core.stepper = std::make_shared<const ContactStepper>(core.stepper, step, core.constants);
    expect_the_runs_of_the_shipped_core(core);
  }
}

TEST(CompleteByStep, FindsTheConstantsThatTheClassGivesOtherNames) {
  Core core = shipped_core();
  core.constants.reset();
  complete_by_step(core);
  ASSERT_TRUE(core.constants);
  EXPECT_TRUE(same_bits(*core.constants, shipped_core().constants.value()));
}

// A spin, which no row shows, turns it.
struct SpinningBody : recording::Body {
  recording::Real spin = 3.0;
};

TEST(ContactStepper, TellsTheContactsOfAStepWithFurtherMembers) {
  const TracedStep step =
      canonical(recording::record_of<SpinningBody>([](SpinningBody& body, const recording::Frame& frame) {
        body.vx = body.vx + body.spin * frame.dt;
        body.spin = body.spin * recording::Real(0.5);
        recording::Listing()(body, frame);
      }));
  const std::optional<Core> core = traced_core(step);  // Knows its contacts.
  Core told = core.value();
  told.stepper = std::make_shared<const ContactStepper>(core->stepper, make_step_program(step), std::nullopt);
  const Event fling{std::int64_t{9'000}, Fling{{-1500.0, -900.0}}};
  for (const Scenario& scenario :
       {eventful_fling(), fling_at(60.0, 20'000), fling_at(60.0, 10'000, {fling})}) {
    TraceSink own, found;
    const std::string expected = text_of(replay(*core, scenario, own));
    EXPECT_EQ(text_of(replay(told, scenario, found)), expected);
    EXPECT_TRUE(same_trace(found, own));
  }
}

TEST(ContactStepper, TellsEachWallByTheStepOrByTheRows) {
  using recording::Real;
  const TracedStep step =
      canonical(recording::record([](recording::Body& body, const recording::Frame& frame) {
        body.vy = body.vy + frame.dt * 1200.0;
        body.x = body.x + body.vx * frame.dt;
        body.y = body.y + body.vy * frame.dt;
        const Real half = Real(frame.window_width - frame.sprite_width) * 0.5;
        if (fabs(body.x - half) > half) body.vx = -body.vx;  // Both walls in one.
        const Real bottom = frame.window_height - frame.sprite_height;
        if (body.y < 0.0) body.vy = fabs(body.vy);
        if (body.y * 2.0 > bottom * 2.0) body.vy = -fabs(body.vy) * 0.9;
      }));
  const std::optional<Core> core = traced_core(step);
  EXPECT_EQ(core.value().sources(), "left, right from the rows");
  const Scenario scenario = fling_at(60.0, 600);
  TraceSink trace;
  replay(*core, scenario, trace);
  const Bounds bounds = bounds_of(scenario.window, scenario.sprite);
  for (std::size_t row = 1; row <= 600; ++row) {
    const Row &before = trace.rows()[row - 1], &after = trace.rows()[row];
    const int by_rows = contact_of_rows(bounds, state_of(before), after.dt_s, state_of(after)) & 3;
    ASSERT_EQ(after.contact, by_rows | (after.y_px > bounds.bottom_px ? bit(Wall::ground) : 0)) << row;
  }
  int told = 0;
  for (const Contact& contact : trace.contacts()) {
    const bool is_in_x = contact.wall == Wall::left || contact.wall == Wall::right;
    EXPECT_EQ(std::isnan(contact.overshoot_px), is_in_x);
    told |= bit(contact.wall);
  }
  EXPECT_EQ(told, bit(Wall::left) | bit(Wall::right) | bit(Wall::ground));
}

TEST(TracedCore, PlaysEveryScenarioAsTheShippedCoreDoes) {
  const std::optional<Core> core = traced_core(canonical(recording::record_listing()));
  EXPECT_FALSE(core.value().constants);
  expect_the_runs_of_the_shipped_core(*core);
}

}  // namespace
}  // namespace hyrax
