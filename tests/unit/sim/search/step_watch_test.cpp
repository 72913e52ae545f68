// A run that keeps the invariants passes; one row that does not is found, by its invariant and its row.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

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
  for (const auto& [name, rule, unit] : kInvariantTexts)
    said.append(name).append(": ").append(rule).append(", ").append(unit).append("\n");
  EXPECT_EQ(said,
            "finite: state and time are finite, time does not go back, decades\n"
            "in-bounds: inside the window after a step, if the sprite fits into it, px\n"
            "step-energy: flight adds no energy, a clamp no more than its lift, px2/s2\n"
            "energy-ceiling: energy never above that after the last input, or of residual speed, px2/s2\n"
            "speed: no faster than the same fling in endless free fall, px/s\n"
            "listing: every step is the paper's with the core's constants, bit for bit, px or px/s\n"
            "mirror: left and right exchanged: the same contacts, to rounding, px\n"
            "no-time: a zero-length frame changes nothing, px/s\n"
            "resumed: stopped and resumed: the same bits as without a stop, 1\n"
            "repeated: run twice: the same bits, repetition skipped or not, 1\n"
            "comes-to-rest: left alone, it settles and ends at zero speed, px/s\n"
            "stays-at-rest: at rest, it stays within half a pixel, however long frames are, s\n"
            "keeps-energy: bounces without loss keep half of the energy, 1\n"
            "exact-corner: the exact fling meets both walls at one time, stays inside, gains no energy, px\n"
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
      {Invariant::listing, [](Row& row) { row.x_px = std::nextafter(row.x_px, 0.0); }},
      {Invariant::listing, [](Row& row) { row.y_px = std::nextafter(row.y_px, 0.0); }},
      {Invariant::listing, [](Row& row) { row.vx_px_per_s = std::nextafter(row.vx_px_per_s, 0.0); }},
      {Invariant::listing, [](Row& row) { row.vy_px_per_s = std::nextafter(row.vy_px_per_s, 0.0); }},
      {Invariant::mirror, [](Row& row) { row.vx_px_per_s *= 0.999; }},
  };
  for (const auto& [invariant, change] : faults) {
    const InvariantMeasure measure = of(watched(fling_at(60.0, 300), kInFlight, change), invariant);
    EXPECT_FALSE(measure.holds) << kInvariantTexts[static_cast<std::size_t>(invariant)].name;
    // The row after the changed one breaks it as well, since its start is changed.
    EXPECT_GE(measure.worst_step, kInFlight);
    EXPECT_LE(measure.worst_step, kInFlight + 1);
  }
}

TEST(StepWatch, HoldsAListingToItsOwnConstants) {
  Core heavier = shipped_core();
  heavier.constants->gravity_px_per_s2 += 1.0;
  EXPECT_FALSE(of(watched(fling_at(60.0, 9), -1, {}, heavier), Invariant::listing).holds);
  heavier = listing_core(*heavier.constants);
  StepWatch watch(heavier, eventful_fling());
  replay(heavier, eventful_fling(), watch);
  EXPECT_TRUE(of(watch.measures(), Invariant::listing).is_checked);
  EXPECT_TRUE(of(watch.measures(), Invariant::listing).holds);
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

TEST(StepWatch, FindsThatDragActsInAZeroLengthFrame) {
  Scenario scenario = fling_at(60.0, 60, {{std::int64_t{20}, Hitch{0.0}}});
  const InvariantMeasures measures = watched(scenario);
  EXPECT_FALSE(of(measures, Invariant::no_time).holds);
  EXPECT_EQ(of(measures, Invariant::no_time).worst_step, 21);
  EXPECT_FALSE(of(watched(fling_at(60.0, 60)), Invariant::no_time).is_checked);
}

}  // namespace
}  // namespace hyrax
