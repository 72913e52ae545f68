// A short run against its kept rows, and the first field in which two rows differ.
#include "sim/compare/run_comparer.h"

#include <gtest/gtest.h>

#include "tests/unit/sim/compare/played_run.h"

namespace hyrax {
namespace {

constexpr std::int64_t kSteps = 330;

class ShortRun : public testing::Test {
 protected:
  const Scenario scenario_ = eventful_fling();
  StoredRun kept_ = kept_run(scenario_);
};

TEST_F(ShortRun, AgreesWithItselfAndWithTheSameScenarioOfOtherTexts) {
  ASSERT_EQ(kept_.rows.size(), kSteps + 1u);
  Scenario renamed = scenario_;
  renamed.name = "another-name";
  renamed.description = "another description";
  renamed.schema = "scenario.schema.json";
  renamed.expect = Expect{.in_bounds = true};
  for (const Scenario& scenario : {scenario_, renamed}) {
    const Comparison comparison = compare(kept_, scenario);
    EXPECT_TRUE(comparison.agrees);
    EXPECT_FALSE(comparison.difference);
    EXPECT_FALSE(comparison.first);
    EXPECT_TRUE(comparison.contacts.is_none());
    EXPECT_EQ(comparison.shape + comparison.physics, "");
  }
}

TEST_F(ShortRun, ContactsOfAWallThatHaveTwoSourcesAreNotComparedWhichItSays) {
  kept_.contacts.clear();
  for (const int other_walls : {0, static_cast<int>(Wall::ground)}) {
    const Comparison comparison = compare(kept_, scenario_, {.other_walls = other_walls});
    EXPECT_EQ(comparison.contacts.is_cut, other_walls != 0);
    for (const Contact& contact : comparison.contacts.only_b)
      EXPECT_EQ(static_cast<int>(contact.wall) & other_walls, 0);
  }
}

// And shown with two rows on either side.
TEST_F(ShortRun, AFaultOfOneUlpIsFoundAtItsStepAndField) {
  for (const std::int64_t step : {std::int64_t{0}, std::int64_t{1}, kSteps / 2, kSteps - 1, kSteps})
    for (const RowField& field : kRowFields) {
      const Comparison comparison = compare(kept_, scenario_, {.fault = one_ulp(step, field.name)});
      ASSERT_EQ(said(comparison), said_of_fault(step, field.name));
      const Row row = kept_.rows.row(static_cast<std::size_t>(step));
      const auto around = static_cast<std::size_t>(std::min<std::int64_t>(step, 2) + 1 +
                                                   std::min<std::int64_t>(kSteps - step, 2));
      EXPECT_EQ(comparison.actual_around.size(), around) << step;
      EXPECT_EQ(comparison.expected_around.size(), around) << step;
      EXPECT_EQ(comparison.first->expected, field.value(row));
      EXPECT_EQ(comparison.first->actual, field.value(with_fault(row, field.name)));
    }
}

TEST_F(ShortRun, ANanInBothIsADifference) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  kept_.rows.x_px.back() = kept_.final.x_px = nan;
  const auto to_nan = [nan](Row row) {
    row.x_px = nan;
    return row;
  };
  EXPECT_EQ(said(compare(kept_, scenario_, {.fault = Fault{kSteps, to_nan}})), "values, first x at 330");
}

TEST_F(ShortRun, AMovedContactIsWorseThanItsBits) {
  kept_.contacts[1].step -= 1;
  const Comparison comparison = compare(kept_, scenario_, {.fault = one_ulp(5, "x")});
  EXPECT_EQ(said(comparison), "contacts, first x at 5, 1 ulps");
  EXPECT_EQ(comparison.contacts.moved.size(), 1u);
}

TEST_F(ShortRun, AFaultOfOneUlpInAContactIsFoundAtItsStepAndField) {
  for (const ContactColumn& quantity : kContactQuantities) {
    StoredRun damaged = kept_;
    Contact& contact = damaged.contacts[1];
    double& value = contact.*std::get<double Contact::*>(quantity.get);
    value = std::nextafter(value, 1e9);
    EXPECT_EQ(said(compare(damaged, scenario_)), "rounding, first contacts/" + std::string(quantity.name) +
                                                     " at " + std::to_string(contact.step) + ", 1 ulps");
  }
}

TEST_F(ShortRun, OfAnotherScenarioOrLengthDiffersInShapeEvenWithEqualRows) {
  Scenario other = scenario_, longer = scenario_;
  other.record_every = 2;
  longer.length = kSteps + 1;
  for (const Scenario& scenario : {other, longer}) {
    const Comparison comparison = compare(kept_, scenario);
    EXPECT_EQ(comparison.difference, DifferenceClass::shape);
    EXPECT_EQ(comparison.shape, "the scenario changed since it was blessed");
  }
  kept_.scenario = longer;  // A truncated golden file names the same scenario.
  const Comparison comparison = compare(kept_, longer);
  EXPECT_EQ(comparison.difference, DifferenceClass::shape);
  EXPECT_EQ(comparison.shape, "the golden file has 330 steps, the run has 331");
}

TEST_F(ShortRun, ThePhysicsModelsNameSetsNoClass) {
  Comparison comparison = compare(kept_, scenario_, {.physics = "hyrax-physics/2"});
  EXPECT_TRUE(comparison.agrees);
  EXPECT_FALSE(comparison.difference);
  EXPECT_EQ(comparison.physics,
            "the golden file is of physics model 'hyrax-physics/1', this program is of 'hyrax-physics/2'");
  comparison = compare(kept_, scenario_, {.fault = one_ulp(7, "x"), .physics = "hyrax-physics/2"});
  EXPECT_EQ(comparison.difference, DifferenceClass::rounding);
  EXPECT_NE(comparison.physics, "");
}

TEST_F(ShortRun, ThatContradictsItselfDoesNotAgree) {
  const auto expect_found = [&, whole = kept_](const std::string& what) {
    const Comparison comparison = compare(kept_, scenario_);
    kept_ = whole;
    EXPECT_EQ(comparison.difference, DifferenceClass::shape);
    EXPECT_EQ(comparison.shape, "the golden file contradicts itself (" + what +
                                    "): its rows agree with the run; it was changed after blessing");
  };
  kept_.state_hash.front() ^= 1;
  expect_found("state hash");
  kept_.inputs.front().action = Fling{{1.0, 2.0}};
  expect_found("events");
  kept_.contacts_total += 1;
  expect_found("number of contacts");
  kept_.final.y_px += 1.0;
  expect_found("last row");
}

// A sprite wider than its window touches both walls in turn.
TEST(KnockingRun, OfMoreContactsThanAreRecordedHasTheRestCounted) {
  Scenario scenario = fling_at(60.0, kContactsRecordedMax + 100);
  scenario.window = {100, 1080};
  StoredRun kept = kept_run(scenario);
  ASSERT_EQ(kept.contacts_total, kContactsRecordedMax);
  kept.contacts_total += 100;
  EXPECT_TRUE(compare(kept, scenario).agrees);
  kept.contacts.pop_back();
  EXPECT_FALSE(compare(kept, scenario).agrees);
}

Row some_row() {
  return {.step = 7,
          .t_s = 0.5,
          .dt_s = 1.0 / 60.0,
          .x_px = 300.0,
          .y_px = 500.0,
          .vx_px_per_s = -2400.0,
          .vy_px_per_s = 1e-300,
          .contact = 3};
}

TEST(FirstDifference, ComparesTheFieldsInOrder) {
  Row actual = some_row();
  for (auto field = kRowFields.rbegin(); field != kRowFields.rend(); ++field) {
    actual = with_fault(actual, field->name);
    EXPECT_EQ(first_difference(some_row(), actual)->field, field->name);
  }
}

TEST(FirstDifference, DistinguishesSignedZeros) {
  Row expected = some_row(), actual = some_row();
  expected.vx_px_per_s = 0.0;
  actual.vx_px_per_s = -0.0;
  const auto first = first_difference(expected, actual);
  EXPECT_EQ(first.value().field, "vx");
  EXPECT_EQ(first->ulps(), 0u);
}

TEST(FirstDifference, FindsANanDifferentFromEverything) {
  for (const RowField& field : kRowFields) {
    if (field.name == "contact") continue;
    Row with_nan = some_row();
    with_nan.*kFaultyFields.at(field.name) = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [expected, actual] :
         {std::pair{some_row(), with_nan}, {with_nan, some_row()}, {with_nan, with_nan}}) {
      const auto first = first_difference(expected, actual);
      EXPECT_EQ(first.value().field, field.name);
      EXPECT_EQ(first->ulps(), std::nullopt);
    }
  }
}

}  // namespace
}  // namespace hyrax
