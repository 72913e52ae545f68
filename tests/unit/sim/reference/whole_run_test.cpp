// The exact fling against motions whose impacts are known in closed form, and the whole run against it where
// inputs, repetition and other constants have a part in it; its numbers are held to a second program's by
// tests/cli/drift_numbers_test.py.
#include "sim/reference/whole_run.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/core/shipped_core.h"
#include "sim/reference/exact_fling.h"
#include "tests/unit/sim/reference/test_run.h"
#include "tests/unit/sim/reference/wide.h"

namespace hyrax {
namespace {

WholeOutcome outcome_of(const Scenario& scenario, const Columns& rows, const Model& model = {}) {
  WholeMeter meter(scenario, inputs_of(scenario), model);
  meter.rows(rows);
  return meter.finish();
}
WholeRun whole_of(const Scenario& scenario, const Columns& rows) {
  return outcome_of(scenario, rows).run.value();
}
WholeRun whole_of(const Scenario& scenario) { return whole_of(scenario, rows_of(scenario)); }

// Of the run, and of a fling within it that begins in the same way.
TEST(WholeRun, NamesTheFirstContactThatIsNotTheExactImpacts) {
  for (const std::int64_t begin : {0, 300}) {
    Scenario scenario = fling();
    if (begin > 0)
      scenario.events = {{begin, Place{scenario.start}}, {begin, Fling{scenario.start_velocity}}};
    Columns rows = rows_of(scenario);
    EXPECT_FALSE(whole_of(scenario, rows).contacts_differ_from) << begin;
    auto second = static_cast<std::size_t>(begin) + 1;
    for (int contacts = 0; contacts < 2; ++second)
      if (rows.contact[second] != 0) ++contacts;
    --second;
    ASSERT_EQ(rows.contact[second], static_cast<std::uint8_t>(Wall::ground));
    rows.contact[second] = static_cast<std::uint8_t>(Wall::left);
    EXPECT_EQ(whole_of(scenario, rows).contacts_differ_from, static_cast<std::int64_t>(second)) << begin;
  }
}

// Of a sprite that flies, slides or has long been still when inputs set all that it goes on from.
TEST(WholeRun, AfterInputsIsThatOfAFlingThatBeginsThere) {
  Scenario after = fling();
  after.window = {2560, 1440};
  const double floor_px = bounds_of(after.window, after.sprite).bottom_px;
  for (const Position& place : {after.start, Position{300.0, floor_px}}) {
    after.start = place;
    if (place.y_px == floor_px) after.start_velocity.vy_px_per_s = 0.0;
    const WholeRun alone = whole_of(after);
    for (const std::int64_t frame : {20, 330, 2000}) {
      const bool has_slid = frame > 20;
      if (has_slid && place.y_px == floor_px) continue;  // It slides on, without the impact.
      Scenario scenario = fling();
      scenario.length = frame + step_count(after);
      scenario.events = {
          {frame, Resize{after.window, {}}}, {frame, Place{place}}, {frame, Fling{after.start_velocity}}};
      const WholeRun whole = whole_of(scenario);
      EXPECT_NEAR(whole.end_px, alone.end_px, 1e-6) << frame;
      EXPECT_EQ(whole.contacts_differ_from.has_value(), alone.contacts_differ_from.has_value()) << frame;
    }
  }
}

// At 100 Hz the sprite ends in two states by turns.
TEST(WholeRun, OfARepetitionIsThatOfEveryRow) {
  std::vector<double> energy_end_px;
  for (const std::int64_t steps : {60'000, 60'001}) {
    const Scenario scenario = fling_at(100.0, steps);
    WholeMeter live(scenario, inputs_of(scenario));
    replay(shipped_core(), scenario, live);
    EXPECT_EQ(live.wants().rows_every, 0) << "the rest is not played";
    const WholeRun skipped = live.finish().run.value();
    const WholeRun every = whole_of(scenario);
    EXPECT_EQ(skipped.end_px, every.end_px);
    EXPECT_EQ(skipped.max_px, every.max_px);
    EXPECT_EQ(skipped.max_px_step, every.max_px_step);
    EXPECT_EQ(skipped.energy_end_px, every.energy_end_px);
    energy_end_px.push_back(every.energy_end_px);
  }
  EXPECT_NE(energy_end_px[0], energy_end_px[1]);
}

TEST(WholeRun, IsNoneWithoutAnExactFling) {
  const auto why = [](double Model::*constant, double value) {
    Model model;
    model.*constant = value;
    const WholeOutcome outcome = outcome_of(fling(), rows_of(fling()), model);
    EXPECT_EQ(outcome.run.has_value(), outcome.why_not.empty());
    return outcome.why_not;
  };
  EXPECT_EQ(why(&Model::restitution, 0.6), "");
  EXPECT_EQ(why(&Model::gravity_px_per_s2, 0.0), "gravity is 0");
  EXPECT_EQ(why(&Model::ground_friction, 0.0), "the friction factor is not above 0 and at most 1");
  EXPECT_EQ(why(&Model::restitution, 1.5), "the restitution is not 0 to 1");
  EXPECT_EQ(why(&Model::rest_threshold_px_per_s, 0.0), "the rest threshold is 0");
  Scenario small = fling();
  small.events = {{std::int64_t{7}, Resize{Size{100, 100}, std::nullopt}}};
  EXPECT_EQ(outcome_of(small, rows_of(small)).why_not, "the sprite is larger than its window in row 7");
}

// A factor of 1 is a law that is left out.
TEST(WholeRun, IsOneWithoutDragFrictionAndLosses) {
  for (double Model::*const factor : {&Model::air_drag, &Model::ground_friction, &Model::restitution}) {
    Model model;
    model.*factor = 1.0;
    const Scenario scenario = fling();
    EXPECT_GT(outcome_of(scenario, rows_of(scenario), model).run.value().end_px, 0.0);
  }
}

// A lossless sprite in a slit meets walls for ever.
TEST(WholeRun, IsNoneWhereTheExactFlingMeetsTooManyWalls) {
  Scenario scenario = fling();
  scenario.window = {scenario.sprite.width_px, scenario.window.height_px};
  scenario.start = {};
  Model lossless;
  lossless.restitution = 1.0;
  EXPECT_EQ(outcome_of(scenario, rows_of(scenario), lossless).why_not,
            "the exact fling has met a million walls in row 1");
}

WholeOutcome enclosed(const Scenario& scenario, const Model& model = {}) {
  WholeMeter meter(scenario, inputs_of(scenario), model, nullptr, true);
  meter.rows(rows_of(scenario));
  return meter.finish();
}

// Through inputs of all kinds, to rest, and where the frames are long; control: of other laws they hold
// another fling.
TEST(WholeRun, IsWithinBoundsThatAreNarrow) {
  Scenario throws = fling();
  throws.events = {{std::int64_t{50}, Fling{{-1500.0, -900.0}}},
                   {std::int64_t{90}, Hitch{0.3}},
                   {std::int64_t{150}, Resize{Size{1500, 900}, std::nullopt}},
                   {std::int64_t{200}, Grab{}},
                   {std::int64_t{205}, Place{{600.0, 300.0}}},
                   {std::int64_t{220}, Release{{300.0, -700.0}}},
                   {std::int64_t{550}, Stop{}}};
  for (const Scenario& scenario : {fling(), throws, fling_at(100.0, 60'000), fling_at(5.0, 40)}) {
    const WholeOutcome outcome = enclosed(scenario);
    const WholeRun& whole = *outcome.run;
    EXPECT_EQ(outcome.enclosure_why, "");
    EXPECT_LE(*whole.end_px_low, whole.end_px + 1e-10);
    EXPECT_GE(*whole.end_px_high, whole.end_px - 1e-10);
    EXPECT_LE(*whole.end_px_high - *whole.end_px_low, 1e-10);
    EXPECT_LE(*whole.max_px_low, whole.max_px + 1e-10);
    EXPECT_GE(*whole.max_px_high, whole.max_px - 1e-10);
    EXPECT_LE(*whole.max_px_high - *whole.max_px_low, 1e-10);
    Model softer;
    softer.restitution = 0.6000001;
    EXPECT_GT(std::fabs(*enclosed(scenario, softer).run->max_px_low - *whole.max_px_low), 1e-7);
    EXPECT_FALSE(whole_of(scenario).end_px_low) << "only where it is asked for";
  }
}

// The time since an input is no double: at this speed its rounding is wider than the bounds.
TEST(WholeRun, IsWithinItsBoundsAfterAnInputToo) {
  Model dragless;
  dragless.air_drag = 1.0;
  Scenario scenario = fling_at(10.0, 0);
  scenario.window = {1'000'000, 1'000'000};
  const Fling input{{1e5, 1e3}};
  scenario.events = {{std::int64_t{3}, input}, {std::int64_t{3}, Place{{0.0, 0.0}}}};
  for (std::int64_t steps = 4; steps < 40; ++steps) {
    scenario.length = steps;
    const Columns rows = rows_of(scenario);
    const WholeRun whole = *enclosed(scenario, dragless).run;
    const Wide since_s = Wide(rows.t_s.back()) - rows.t_s[3];
    const Wide dx_px = since_s * input.velocity.vx_px_per_s - rows.x_px.back();
    const Wide dy_px = since_s * (since_s * 600.0 + input.velocity.vy_px_per_s) - rows.y_px.back();
    const Wide squared = dx_px * dx_px + dy_px * dy_px;
    EXPECT_FALSE(squared < Wide(*whole.end_px_low) * *whole.end_px_low) << steps;
    EXPECT_FALSE(Wide(*whole.end_px_high) * *whole.end_px_high < squared) << steps;
  }
}

// Both walls of the corner after one second exactly.
TEST(WholeRun, HasNoBoundsWhereTheOrderOfImpactsCannotBeDecided) {
  Scenario scenario = fling();
  scenario.start = {1292.0, 252.0};
  scenario.start_velocity = {500.0, 100.0};
  Model dragless;
  dragless.air_drag = 1.0;
  const WholeOutcome outcome = enclosed(scenario, dragless);
  EXPECT_EQ(outcome.enclosure_why, "which of two walls is met first");
  EXPECT_FALSE(outcome.run->end_px_low || outcome.run->end_px_high || outcome.run->max_px_low ||
               outcome.run->max_px_high);
  EXPECT_GT(outcome.run->end_px, 0.0);
}

// Both walls at one place: a speed between them turns at once, and again, until nothing is left of it.
TEST(WholeRun, OfASpriteThatFillsItsWindowComesToAnEnd) {
  Scenario scenario = fling();
  scenario.window = scenario.sprite;
  scenario.start = {};
  EXPECT_LT(whole_of(scenario).end_px, 1e-300);
}

constexpr Bounds kBounds{1000.0, 1000.0};

// Without drag a drop from height h takes sqrt(2 h / g), and each bounce 0.6 of the one before.
FixedLaws without_drag() {
  Model model;
  model.air_drag = 1.0;
  return FixedLaws(model);
}

TEST(ExactFling, BouncesAsADropWithoutDragDoes) {
  ExactFling fling(without_drag());
  fling.start({500.0, 400.0, 0.0, 0.0}, kBounds);
  EXPECT_EQ(fling.at(10.0).y_px, 1000.0);
  const double fall_s = std::sqrt(2.0 * 600.0 / 1200.0);
  const double speed_px_per_s = 1200.0 * fall_s;
  double expected_s = fall_s;
  double left_px_per_s = 0.6 * speed_px_per_s;
  for (const ExactImpact& impact : fling.impacts()) {
    EXPECT_EQ(impact.wall, Wall::ground);
    EXPECT_NEAR(impact.t_s, expected_s, 1e-12);
    expected_s += 2.0 * left_px_per_s / 1200.0;
    left_px_per_s *= 0.6;
  }
  // 1200 * 0.6^n < 5 first for n = 11.
  EXPECT_EQ(fling.impacts().size(), 11u);
  EXPECT_EQ(fling.at(11.0).vy_px_per_s, 0.0);
}

TEST(ExactFling, AStartOutsideIsPutOntoItsWall) {
  ExactFling fling;
  fling.start({-50.0, 500.0, -100.0, 0.0}, kBounds);
  EXPECT_EQ(fling.at(0.0).x_px, 0.0);
  EXPECT_EQ(fling.at(0.0).vx_px_per_s, 60.0);
}

}  // namespace
}  // namespace hyrax
