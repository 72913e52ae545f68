// A run that keeps the invariants passes; one row that does not is found, by its invariant and its row.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "sim/core/kernel_of.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/search/step_watch.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

// Of a run with one row changed.
InvariantMeasures watched(const Scenario& scenario, std::int64_t step = -1,
                          const std::function<void(Row&)>& change = {}, const Core& core = shipped_core()) {
  TraceSink trace({.rows_every = 1});
  replay(shipped_core(), scenario, trace);
  Columns rows;
  for (Row row : trace.rows()) {
    if (row.step == step) change(row);
    rows.append(row);
  }
  StepWatch watch(core, scenario);
  watch.rows(rows);
  return watch.measures();
}

const InvariantMeasure& of(const InvariantMeasures& measures, Invariant invariant) {
  return measures[static_cast<std::size_t>(invariant)];
}

// In flight at this row, far from all walls.
constexpr std::int64_t kInFlight = 10;

// As fuzz and the study of hard cases print them.
TEST(Invariants, AreCalledBy) {
  std::string said;
  for (const auto& [name, rule, unit, is_general] : kInvariantTexts)
    said.append(name).append(": ").append(rule).append(", ").append(unit).append(
        is_general ? ", of any core\n" : "\n");
  EXPECT_EQ(
      said,
      "finite: state and time are finite, time does not go back, decades, of any core\n"
      "in-bounds: inside the window after a step, if the sprite fits into it, px, of any core\n"
      "step-energy: flight adds no energy, a clamp no more than its lift, px2/s2, of any core\n"
      "energy-ceiling: energy never above that after the last input, or of residual speed, px2/s2, of any "
      "core\n"
      "speed: no faster than the same fling in endless free fall, px/s\n"
      "velocity: a flight changes vx to a vx, vy to a (vy + G dt), bit for bit, px/s\n"
      "position: a flight adds dt times the new velocity to x and y, bit for bit, px\n"
      "clamp: no clamp without overshoot, no overshoot without clamp, px\n"
      "bounce: a clamp turns the speed with the restitution, friction and rest rule on the ground, px/s\n"
      "mirror: left and right exchanged: the same contacts, to rounding, px, of any core\n"
      "y-alone: y and vy are the same bits whatever x does, px/s\n"
      "no-time: a zero-length frame changes nothing, px/s\n"
      "resumed: stopped and resumed: the same bits as without a stop, 1, of any core\n"
      "repeated: run twice: the same bits, repetition skipped or not, 1, of any core\n"
      "comes-to-rest: left alone, it settles and ends at zero speed, px/s\n"
      "expectations: what the scenario itself expects, 1\n");
}

TEST(StepWatch, FindsARowThatBreaksAnInvariant) {
  struct Fault {
    Invariant invariant;
    void (*change)(Row&);
  };
  const Fault faults[] = {
      {Invariant::finite, [](Row& row) { row.vx_px_per_s = std::nan(""); }},
      {Invariant::finite, [](Row& row) { row.t_s -= 1.0; }},
      {Invariant::in_bounds, [](Row& row) { row.x_px = -1e-9; }},
      {Invariant::step_energy, [](Row& row) { row.y_px -= 20.0; }},
      {Invariant::energy_ceiling, [](Row& row) { row.y_px -= 200.0; }},
      {Invariant::speed, [](Row& row) { row.vx_px_per_s = std::nextafter(row.vx_px_per_s, 1e9); }},
      {Invariant::clamp, [](Row& row) { row.x_px = std::nextafter(row.x_px, 0.0); }},
      {Invariant::mirror, [](Row& row) { row.vx_px_per_s *= 0.999; }},
      {Invariant::y_alone, [](Row& row) { row.vy_px_per_s = std::nextafter(row.vy_px_per_s, 0.0); }},
  };
  for (const auto& [invariant, change] : faults) {
    const InvariantMeasure measure = of(watched(fling_at(60.0, 300), kInFlight, change), invariant);
    EXPECT_FALSE(measure.holds) << kInvariantTexts[static_cast<std::size_t>(invariant)].name;
    // The row after the changed one breaks it as well, since its start is changed.
    EXPECT_GE(measure.worst_step, kInFlight);
    EXPECT_LE(measure.worst_step, kInFlight + 1);
  }
}

// Moves with the velocity before gravity.
struct ExplicitStep {
  void operator()(State& s, double dt_s, const Bounds&) const {
    s.x_px += s.vx_px_per_s * dt_s;
    s.y_px += s.vy_px_per_s * dt_s;
    s.vx_px_per_s *= 0.999;
    s.vy_px_per_s = (s.vy_px_per_s + 1200.0 * dt_s) * 0.999;
  }
};

TEST(StepWatch, FindsAFlightThatIsNotThePapers) {
  Core moves_first{.constants = shipped_core().constants}, heavier = shipped_core();
  heavier.constants->gravity_px_per_s2 += 1.0;
  moves_first.kernel = std::make_shared<const KernelOf<StepCores<ExplicitStep>>>();
  for (Core* const core : {&heavier, &moves_first}) {
    const InvariantMeasures measures = watched(fling_at(60.0, 9), -1, {}, *core);
    EXPECT_EQ(of(measures, Invariant::velocity).holds, core != &heavier);
    EXPECT_EQ(of(measures, Invariant::position).holds, core == &heavier);
  }
}

TEST(StepWatch, ASpriteThatDoesNotFitInOneDirectionIsWatchedInTheOther) {
  Scenario wide = fling_at(60.0, 60);
  wide.sprite.width_px = wide.window.width_px + 1;
  EXPECT_TRUE(of(watched(wide), Invariant::in_bounds).is_checked);
  const auto below = [&wide](Row& row) { row.y_px = wide.window.height_px; };
  EXPECT_FALSE(of(watched(wide, kInFlight, below), Invariant::in_bounds).holds);
  wide.sprite.height_px = wide.window.height_px + 1;
  EXPECT_FALSE(of(watched(wide), Invariant::in_bounds).is_checked);
}

// Each wall met in one frame, its row changed by an ulp in one speed.
TEST(StepWatch, FindsASpeedThatNoBounceLeaves) {
  struct Throw {
    Position start;
    Velocity velocity;
  };
  for (const Throw& at : {Throw{{1.0, 300.0}, {-900.0, 0.0}}, Throw{{1791.0, 300.0}, {900.0, 0.0}},
                          Throw{{500.0, 1.0}, {300.0, -900.0}}, Throw{{500.0, 951.0}, {300.0, 900.0}}})
    for (double Row::*const speed : {&Row::vx_px_per_s, &Row::vy_px_per_s}) {
      Scenario scenario = fling_at(60.0, 1);
      scenario.window = {1920, 1080};
      scenario.sprite = {128, 128};
      scenario.start = at.start;
      scenario.start_velocity = at.velocity;
      EXPECT_TRUE(of(watched(scenario), Invariant::bounce).is_checked);
      EXPECT_TRUE(of(watched(scenario), Invariant::bounce).holds);
      const auto change = [speed](Row& row) { row.*speed = std::nextafter(row.*speed, 0.0); };
      EXPECT_FALSE(of(watched(scenario, 1, change), Invariant::bounce).holds) << at.start.x_px;
    }
}

TEST(StepWatch, FindsThatDragActsInAZeroLengthFrame) {
  Scenario scenario = fling_at(60.0, 60, {{std::int64_t{20}, Hitch{0.0}}});
  const InvariantMeasures measures = watched(scenario);
  EXPECT_FALSE(of(measures, Invariant::no_time).holds);
  EXPECT_EQ(of(measures, Invariant::no_time).worst_step, 21);
  EXPECT_FALSE(of(watched(fling_at(60.0, 60)), Invariant::no_time).is_checked);
}

}  // namespace
}  // namespace hyrax
