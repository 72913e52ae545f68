#include "sim/described/described_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/sim/described/core_for_test.h"

namespace hyrax {
namespace {

enum class Gear : std::int8_t { neutral, drive };

struct Car {
  double x_px = 0.0;
  double y_px = 0.0;
  double v_px_per_s = 60.0;
  float spin = 0.5F;
  Gear gear = Gear::neutral;
  std::int32_t odometer_m = 0;
  bool touches = false;
  void step(double dt_s) { x_px += v_px_per_s * dt_s; }
  void state(auto&& see) {
    see("x_px", x_px);
    see("y_px", y_px);
    see("v_px_per_s", v_px_per_s);
    see("spin", spin);
    see("gear", gear, {"neutral", "drive"});
    see("odometer_m", odometer_m);
  }
  void contacts(auto&& see) const { see("wall", touches); }
  void actions(auto&& see) {
    see("jump", [&] { x_px += 1000.0; });
  }
};

const DescribedCore& car() {
  static const DescribedCore core = core_for_test<Car>();
  return core;
}

KeptRow row_at(std::int64_t step, Car car) {
  return {step,
          static_cast<double>(step) / 60.0,
          step == 0 ? 0.0 : 1.0 / 60.0,
          {word_of(car.x_px), word_of(car.y_px), word_of(car.v_px_per_s), word_of(car.spin),
           word_of(car.gear), word_of(car.odometer_m)},
          {static_cast<std::uint8_t>(car.touches)}};
}

// Two rows, of which the second may be another one.
DescribedComparison compare_with(const Car& other, const Tolerance& tolerance = {}) {
  const auto side = [](const Car& last) {
    DescribedRows rows;
    rows.append(row_at(0, {}));
    rows.append(row_at(1, last));
    return ComparedSide{batches_of(rows), {}, {}};
  };
  return compare_runs(car().description, side({}), side(other), tolerance);
}

TEST(DescribedComparison, HasTheClassOfWhatDiffers) {
  EXPECT_TRUE(compare_with({}).agrees());
  const auto class_of = [](const Car& other) { return compare_with(other).difference; };
  EXPECT_EQ(class_of({.x_px = 1e-9}), DifferenceClass::rounding);
  EXPECT_EQ(class_of({.x_px = 1.1e-9}), DifferenceClass::values);
  EXPECT_EQ(class_of({.v_px_per_s = 60.0 + 59e-9}), DifferenceClass::rounding);
  EXPECT_EQ(class_of({.spin = 0.500009F}), DifferenceClass::rounding);
  EXPECT_EQ(class_of({.spin = 0.50002F}), DifferenceClass::values);
  EXPECT_EQ(class_of({.x_px = std::nan("")}), DifferenceClass::values);
  EXPECT_EQ(class_of({.odometer_m = 1}), DifferenceClass::values) << "an integer with a unit";
  EXPECT_EQ(class_of({.gear = Gear::drive}), DifferenceClass::contacts);
  EXPECT_EQ(class_of({.touches = true}), DifferenceClass::contacts);
}

TEST(DescribedComparison, TellsTheFirstDifferenceInItsOwnType) {
  const DescribedComparison of_float = compare_with({.spin = std::nextafter(0.5F, 1.0F), .touches = true});
  ASSERT_TRUE(of_float.first);
  EXPECT_EQ(of_float.first->step, 1);
  EXPECT_EQ(of_float.first->value.name, "spin");
  EXPECT_EQ(of_float.first->ulps(), 1U);
  const DescribedComparison of_enum = compare_with({.gear = Gear::drive});
  EXPECT_EQ(of_enum.first->value.name, "gear");
  EXPECT_EQ(of_enum.first->actual, Word{1});
  EXPECT_FALSE(of_enum.first->ulps());
  EXPECT_EQ(compare_with({.touches = true}).first->value.name, "wall");
}

TEST(DescribedComparison, MeasuresPairsInPxAndTheLargestOfEachUnit) {
  const DescribedComparison comparison = compare_with({.x_px = 3.0, .y_px = -4.0, .odometer_m = -7});
  EXPECT_EQ(comparison.max_px(), 5.0);
  EXPECT_EQ(comparison.distance.largest->step, 1);
  EXPECT_EQ(comparison.max,
            (std::map<std::string, double>{{"", 0.0}, {"m", 7.0}, {"px", 4.0}, {"px/s", 0.0}}));
  EXPECT_EQ(compare_with({.x_px = std::nan("")}).max_px(), std::numeric_limits<double>::infinity());
}

TEST(DescribedComparison, OfTwoDescriptionsItComparesWhatBothHave) {
  // Without spin, y behind gear; and a contact in front of the wall.
  Description before = car().description;
  const std::vector<std::size_t> order = {0, 2, 4, 1, 5};
  before.state.values.clear();
  for (const std::size_t place : order) before.state.values.push_back(car().description.state.values[place]);
  before.contacts = {"rail", "wall"};
  const auto rows_of = [&](const Car& last, bool is_before) {
    DescribedRows rows;
    for (const auto& [step, of] : {std::pair(0, Car()), {1, last}}) {
      KeptRow row = row_at(step, of);
      std::vector<Word> state;
      for (const std::size_t place : order) state.push_back(row.state[place]);
      if (is_before) row = {row.step, row.t_s, row.dt_s, state, {1, row.contacts.front()}};
      rows.append(row);
    }
    return batches_of(rows);
  };
  const auto compare = [&](const Car& other) {
    return compare_common(before, {rows_of({}, true), {}, {{0, 0, 1, 0.0}, {1, 1, 1, 0.0}}},
                          car().description, {rows_of(other, false), {}, {{0, 1, 1, 0.0}}});
  };
  EXPECT_TRUE(compare({.spin = 0.75F}).agrees()) << "what only one has is not compared";
  EXPECT_EQ(compare({.y_px = 4.0}).max_px(), 4.0);
  EXPECT_EQ(compare({.gear = Gear::drive}).first->value.name, "gear");
  EXPECT_EQ(compare({.touches = true}).first->value.name, "wall");
}

TEST(DescribedComparison, AgreesWithinATolerance) {
  const Car other{.x_px = 0.5};
  const Tolerance within_half{0.5, {}, {}};
  EXPECT_TRUE(compare_with(other, within_half).agrees());
  EXPECT_FALSE(compare_with(other, Tolerance{0.4, {}, {}}).agrees());
  EXPECT_FALSE(compare_with({.odometer_m = 1}, Tolerance{2.0, {}, {}}).agrees())
      << "an integer agrees only with itself";
  EXPECT_EQ(compare_with(other, within_half).worst.front().abs, 0.5);
}

ComparedSide played(const DescribedScenario& scenario) {
  RowsForTest kept;
  const DescribedSummary summary = play_for_test(car(), scenario, kept);
  DescribedRows rows;
  for (const RowsForTest::Kept& row : kept.rows) rows.append(row);
  return {batches_of(rows), jump_frames(scenario, summary.steps), {}};
}

TEST(DescribedComparison, RunsOfOtherFramesAreMeasuredAtEqualTimes) {
  DescribedScenario at_60_hz = scenario_for_test(60), at_30_hz = scenario_for_test(30);
  at_30_hz.clock.base = FixedRate{30.0};
  const DescribedComparison same_way = compare_runs(car().description, played(at_60_hz), played(at_30_hz));
  EXPECT_TRUE(same_way.distance.is_at_equal_times);
  EXPECT_EQ(same_way.difference, DifferenceClass::values);
  EXPECT_LT(*same_way.max_px(), 1e-9);
  at_60_hz.events = {event_for_test(20, Act{})};
  at_30_hz.events = {event_for_test(10, Act{})};
  const DescribedComparison with_jumps = compare_runs(car().description, played(at_60_hz), played(at_30_hz));
  EXPECT_EQ(with_jumps.distance.frames_left_out, 2);
  EXPECT_LT(*with_jumps.max_px(), 1e-9);
}

TEST(DescribedComparison, BlocksTellInWhichTheDifferenceIs) {
  DescribedBlock block;
  block.keyframe.state = row_at(0, {}).state;
  std::vector<DescribedBlock> blocks(3, block);
  blocks[2].keyframe.step = 8192;
  EXPECT_TRUE(compare_blocks(car().description, blocks, blocks).agrees());
  std::vector<DescribedBlock> others = blocks;
  others[2].digest[0] ^= 1;
  const DescribedComparison unknown = compare_blocks(car().description, blocks, others);
  EXPECT_EQ(unknown.difference, DifferenceClass::values);
  EXPECT_FALSE(unknown.max_px());
  EXPECT_EQ(unknown.first->step, 8192);
  EXPECT_EQ(unknown.first->value.name, "state");
  others[2].keyframe.state[1] = word_of(1.0);
  EXPECT_EQ(compare_blocks(car().description, blocks, others).first->value.name, "y_px");
}

TEST(DescribedComparison, CountsContactsThatMovedVanishedAndAppeared) {
  const std::vector<DescribedContact> before = {{0, 1, 1, 0.0}, {0, 5, 5, 0.0}, {1, 7, 9, 0.0}};
  const std::vector<DescribedContact> after = {{0, 1, 1, 0.0}, {0, 6, 6, 0.0}, {2, 7, 9, 0.0}};
  const ContactCounts counts = contact_counts(before, after);
  EXPECT_EQ(counts.moved, 1);
  EXPECT_EQ(counts.vanished, 1);
  EXPECT_EQ(counts.appeared, 1);
  EXPECT_EQ(contact_counts(before, before).total(), 0);
}

TEST(DescribedExpectations, EachRuleHoldsAndIsBroken) {
  DescribedSummary summary;
  summary.final = row_at(1, {.x_px = 3.0, .gear = Gear::drive}).state;
  summary.contacts = {2};
  const auto verdict = [&](const DescribedExpect& expect) {
    const std::vector<Expectation> verdicts = judge(car().description, expect, summary);
    return verdicts.size() == 1 ? verdicts.front() : Expectation{"not one", "", false, {}};
  };
  const auto range = [](auto low, auto high) { return std::array{word_of(low), word_of(high)}; };
  const Expectation of_x = verdict({.final = {{0, range(2.0, 4.0)}}});
  EXPECT_EQ(of_x.rule, "final/x_px");
  EXPECT_EQ(of_x.wanted, "2 .. 4");
  EXPECT_TRUE(of_x.holds);
  EXPECT_FALSE(verdict({.final = {{0, range(3.5, 4.0)}}}).holds);
  const Expectation of_spin = verdict({.final = {{3, range(0.1F, 0.1F)}}});  // Of a float, shortest for it.
  EXPECT_EQ(of_spin.wanted, "0.1");
  EXPECT_EQ(of_spin.range->low, 0.1F);  // Moves with `--update-expect`.
  summary.final[3] = word_of(0.3F);
  EXPECT_EQ(std::get<double>(verdict({.final = {{3, range(0.1F, 0.2F)}}}).measured), 0.3);
  const Expectation of_gear = verdict({.final = {{4, range(Gear::neutral, Gear::neutral)}}});
  EXPECT_FALSE(of_gear.holds);
  EXPECT_EQ(of_gear.wanted, "neutral");
  EXPECT_EQ(std::get<std::string>(of_gear.measured), "drive");
  EXPECT_FALSE(of_gear.range);
  EXPECT_TRUE(verdict({.final = {{4, range(Gear::drive, Gear::drive)}}}).holds);
  const Expectation of_odometer = verdict({.final = {{5, range(std::int32_t{3}, std::int32_t{3})}}});
  EXPECT_FALSE(of_odometer.holds);
  EXPECT_EQ(of_odometer.wanted, "3");
  ASSERT_TRUE(of_odometer.range) << "a count moves with `--update-expect`";
  EXPECT_EQ(of_odometer.range->high, 3.0);
  EXPECT_TRUE(verdict({.contacts = {{0, {2.0, 2.0}}}}).holds);
  EXPECT_FALSE(verdict({.contacts = {{0, {0.0, 1.0}}}}).holds);
  EXPECT_FALSE(verdict({.at_rest_since_s = Interval{0.0, 9.0}}).holds);
  EXPECT_TRUE(verdict({.finite = true}).holds);
  summary.early_end = {1, "x_px is not finite", true};
  EXPECT_FALSE(verdict({.finite = true}).holds);
  EXPECT_TRUE(verdict({.state_hash = hex(summary.state_hash)}).holds);
  EXPECT_FALSE(verdict({.state_hash = std::string(32, 'f')}).holds);
}

}  // namespace
}  // namespace hyrax
