// A long run against its kept blocks.
#include <gtest/gtest.h>

#include "tests/unit/sim/compare/played_run.h"

namespace hyrax {
namespace {

constexpr auto kBlock = static_cast<std::int64_t>(kBlockRows);
constexpr std::int64_t kLongSteps = 3 * kBlock + 99;

// A jittered clock, so that no two blocks are equal.
Scenario jittered_fling() {
  Scenario scenario = fling_at(60.0, kLongSteps, {{std::int64_t{6000}, Fling{{1500.0, -2500.0}}}});
  scenario.clock.jitter = Jitter{Jitter::Kind::uniform, 0.2, 42};
  return scenario;
}

class LongRun : public testing::Test {
 protected:
  const Scenario scenario_ = jittered_fling();
  StoredRun kept_ = kept_run(scenario_);
};

const std::int64_t kFaultSteps[] = {0, 1, kBlock - 1, kBlock, 3 * kBlock + 50, kLongSteps};

TEST_F(LongRun, AgreesWithItself) {
  ASSERT_EQ(kept_.rows.size(), 0u);
  ASSERT_EQ(kept_.blocks.size(), 4u);
  EXPECT_TRUE(compare(kept_, scenario_).agrees);
  EXPECT_TRUE(compare(kept_, scenario_, {.can_expand = false}).agrees);
}

// With a changed core a block cannot be played again: then the kept row checks find the step.
TEST_F(LongRun, AFaultOfOneUlpIsFoundAtItsStepAndFieldThoughTheCoreHasChanged) {
  for (const std::int64_t step : kFaultSteps)
    for (const RowField& field : kRowFields)
      for (const bool can_expand : {true, false}) {
        if (field.name == "t") continue;  // Blocks hold no t; keyframes do.
        const Playing playing{.fault = one_ulp(step, field.name), .can_expand = can_expand};
        const Comparison comparison = compare(kept_, scenario_, playing);
        EXPECT_EQ(comparison.first.value().step, step) << field.name;
        EXPECT_EQ(comparison.first->field, field.name);
        // Of a kept row that cannot be played, only a keyframe has values.
        EXPECT_EQ(comparison.first->expected.has_value(), can_expand || step % kBlock == 0) << step;
        EXPECT_TRUE(comparison.first->actual) << step;
        if (can_expand) {
          EXPECT_EQ(said(comparison), said_of_fault(step, field.name));
        }
      }
}

TEST_F(LongRun, AFaultIsBoundToItsBlockWhereNothingElseIsKept) {
  for (StoredBlock& block : kept_.blocks) block.checks.clear();
  const Comparison comparison =
      compare(kept_, scenario_, {.fault = one_ulp(kBlock + 77, "vx"), .can_expand = false});
  EXPECT_EQ(said(comparison), "values, first state at 4096") << "how far the rows are apart is not known";
  EXPECT_TRUE(comparison.distance.has_unknown_rows);
  EXPECT_FALSE(comparison.first->expected);
}

// A row in the middle of a block is 2 px away.
TEST_F(LongRun, MeasuresTheLargestDistanceInABlock) {
  const std::int64_t step = kBlock + 1234;
  const Fault fault{step, [](Row row) {
                      row.x_px += 2.0;
                      return row;
                    }};
  Comparison comparison = compare(kept_, scenario_, {.fault = fault});
  EXPECT_EQ(comparison.difference, DifferenceClass::values);
  EXPECT_NEAR(comparison.distance.largest.value().px, 2.0, 1e-9);
  EXPECT_EQ(comparison.distance.largest->step, step);
  EXPECT_FALSE(comparison.distance.has_unknown_rows);
  comparison = compare(kept_, scenario_, {.fault = fault, .can_expand = false});
  EXPECT_TRUE(comparison.distance.has_unknown_rows);
  EXPECT_FALSE(comparison.distance.largest);
}

// Rows that differ in every block: time and step of each are those of its row.
TEST_F(LongRun, MeasuresEveryBlockAfterTheFirstDifference) {
  Scenario other = scenario_;
  other.events = {{std::int64_t{6000}, Fling{{1500.001, -2500.0}}}};
  const Comparison comparison = compare(kept_, other);
  EXPECT_EQ(comparison.first->step, 6001);
  EXPECT_GT(comparison.distance.largest.value().step, 6100);
  EXPECT_GT(comparison.distance.largest->px, 1e-3);
  EXPECT_FALSE(comparison.distance.has_unknown_rows);
}

TEST_F(LongRun, OfAnotherLengthDiffersInShape) {
  for (const std::int64_t steps : {kLongSteps - 1, kLongSteps + 1, kBlock, 5 * kBlock}) {
    Scenario other = scenario_;
    other.length = steps;
    if (steps < 6000) other.events.clear();
    kept_.scenario = other;
    const Comparison comparison = compare(kept_, other);
    EXPECT_EQ(comparison.difference, DifferenceClass::shape) << steps;
    EXPECT_NE(comparison.shape.find(std::to_string(kLongSteps)), std::string::npos) << comparison.shape;
    const bool has_equal_rows = steps >= 6000;
    EXPECT_FALSE(has_equal_rows && compare(kept_run(scenario_), other).first) << steps;
  }
}

TEST_F(LongRun, ADamagedKeyframeIsNoAgreement) {
  void (*const damages[])(StoredBlock&) = {
      [](StoredBlock& b) { b.checks[17][3] ^= 1; },
      [](StoredBlock& b) { b.keyframe.row.t_s = std::nextafter(b.keyframe.row.t_s, 1e9); },
      [](StoredBlock& b) { b.keyframe.row.vy_px_per_s += 1.0; },
      [](StoredBlock& b) { b.keyframe.row.contact ^= 4; },
      [](StoredBlock& b) { ++b.keyframe.timeline.frames; },
      [](StoredBlock& b) { b.keyframe.timeline.dt_s += 1.0; },
      [](StoredBlock& b) { b.keyframe.timeline.base_s += 1.0; },
      [](StoredBlock& b) { b.keyframe.timeline.comp_s += 1.0; },
      [](StoredBlock& b) { ++b.keyframe.window.width_px; },
      [](StoredBlock& b) { ++b.keyframe.sprite.height_px; },
      [](StoredBlock& b) { b.keyframe.is_held = true; }};
  for (std::size_t damage = 0; damage < std::size(damages); ++damage) {
    StoredRun damaged = kept_;
    damages[damage](damaged.blocks[damage % damaged.blocks.size()]);
    const char* const what = damage == 0 ? "row checks" : "keyframes";
    EXPECT_TRUE(compare(damaged, scenario_)
                    .shape.starts_with(std::string("the golden file contradicts itself (") + what + ")"))
        << damage;
  }
}

// A sprite at rest repeats the same block; it is kept once, whether the replay skips repetitions or not.
class RestingRun : public testing::Test {
 protected:
  const Scenario scenario_ = fling_at(240.0, 60 * kBlock);
  StoredRun kept_ = kept_run(scenario_);
};

TEST_F(RestingRun, KeepsARepeatedBlockOnceAndAgreesHoweverItIsPlayed) {
  EXPECT_LT(kept_.blocks.size(), 20u);
  EXPECT_TRUE(compare(kept_, scenario_).agrees);
  EXPECT_TRUE(compare(kept_, scenario_, {.skips_repetition = false}).agrees);
}

TEST_F(RestingRun, AFaultInARepeatedBlockIsFound) {
  const std::int64_t step = 40 * kBlock + 1234;
  const Playing playing{.fault = one_ulp(step, "x"), .skips_repetition = false};
  const Comparison comparison = compare(kept_, scenario_, playing);
  EXPECT_EQ(said(comparison), said_of_fault(step, "x"));
  EXPECT_EQ(comparison.distance.largest.value().step, step);
}

}  // namespace
}  // namespace hyrax
