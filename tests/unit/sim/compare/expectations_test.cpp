// The expectations of a scenario, judged rule by rule.
#include "sim/compare/expectations.h"

#include <gtest/gtest.h>

#include <limits>

namespace hyrax {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

RunSummary some_summary() {
  RunSummary summary;
  summary.contacts = {1, 3, 0, 21};
  summary.final.x_px = 1069.25;
  summary.final.y_px = 592.0;
  summary.at_rest_since_s = 8.25;
  summary.state_hash = {0xab, 0xcd};
  return summary;
}

Expectation verdict(const Expect& expect, const RunSummary& summary = some_summary()) {
  const std::vector<Expectation> verdicts = judge(expect, summary);
  EXPECT_EQ(verdicts.size(), 1u);
  return verdicts.empty() ? Expectation{} : verdicts.front();
}

TEST(Judge, HasNoVerdictsWithoutExpectations) { EXPECT_TRUE(judge({}, some_summary()).empty()); }

TEST(Judge, JudgesInBounds) {
  RunSummary outside = some_summary();
  outside.out_of_bounds_step = 12;
  EXPECT_TRUE(verdict({.in_bounds = true}).holds);
  EXPECT_FALSE(verdict({.in_bounds = true}, outside).holds);
  EXPECT_FALSE(verdict({.in_bounds = false}).holds);
  EXPECT_TRUE(verdict({.in_bounds = false}, outside).holds);
  EXPECT_EQ(verdict({.in_bounds = true}, outside).rule, "in_bounds");
  EXPECT_EQ(std::get<bool>(verdict({.in_bounds = true}, outside).measured), false);
}

TEST(Judge, JudgesFinite) {
  RunSummary blown_up = some_summary();
  blown_up.non_finite_step = 3;
  EXPECT_TRUE(verdict({.finite = true}).holds);
  EXPECT_FALSE(verdict({.finite = true}, blown_up).holds);
  EXPECT_TRUE(verdict({.finite = false}, blown_up).holds);
  EXPECT_EQ(verdict({.finite = true}).rule, "finite");
}

TEST(Judge, TreatsBoundsAsInclusive) {
  EXPECT_TRUE(verdict({.final_x_px = Interval{1069.25, 1069.25}}).holds);
  EXPECT_TRUE(verdict({.final_x_px = Interval{1069.25, 2000.0}}).holds);
  EXPECT_TRUE(verdict({.final_x_px = Interval{0.0, 1069.25}}).holds);
  EXPECT_FALSE(verdict({.final_x_px = Interval{1069.26, 2000.0}}).holds);
  EXPECT_FALSE(verdict({.final_x_px = Interval{0.0, 1069.24}}).holds);
  EXPECT_TRUE(verdict({.final_y_px = Interval{-kInfinity, 592.0}}).holds);
  EXPECT_FALSE(verdict({.final_y_px = Interval{-kInfinity, 591.0}}).holds);
}

TEST(Judge, NamesRuleWantedAndMeasured) {
  const Expectation x = verdict({.final_x_px = Interval{1070.0, 1071.5}});
  EXPECT_EQ(x.rule, "final_x_px");
  EXPECT_EQ(x.wanted, "1070 .. 1071.5");
  EXPECT_EQ(std::get<double>(x.measured), 1069.25);
  EXPECT_EQ(verdict({.final_y_px = Interval{-kInfinity, 9.0}}).rule, "final_y_px");
  EXPECT_EQ(verdict({.final_y_px = Interval{-kInfinity, 9.0}}).wanted, "at most 9");
}

TEST(Judge, JudgesTheTimeOfRest) {
  EXPECT_TRUE(verdict({.at_rest_since_s = Interval{8.0, 8.5}}).holds);
  EXPECT_FALSE(verdict({.at_rest_since_s = Interval{-kInfinity, 8.0}}).holds);
}

TEST(Judge, AcceptsNoTimeOfRestForARestlessRun) {
  RunSummary restless = some_summary();
  restless.at_rest_since_s.reset();
  const Expectation rest = verdict({.at_rest_since_s = Interval{-kInfinity, kInfinity}}, restless);
  EXPECT_FALSE(rest.holds);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(rest.measured));
}

TEST(Judge, CountsTheContactsOfEachWall) {
  Expect expect;
  expect.contacts.left = Interval{1, 1};
  expect.contacts.right = Interval{2, 4};
  expect.contacts.top = Interval{1, 1};
  expect.contacts.ground = Interval{22, 30};
  const std::vector<Expectation> verdicts = judge(expect, some_summary());
  ASSERT_EQ(verdicts.size(), 4u);
  const std::string rules[] = {"contacts/left", "contacts/right", "contacts/top", "contacts/ground"};
  const bool holds[] = {true, true, false, false};
  const double measured[] = {1, 3, 0, 21};
  for (std::size_t wall = 0; wall < 4; ++wall) {
    EXPECT_EQ(verdicts[wall].rule, rules[wall]);
    EXPECT_EQ(verdicts[wall].holds, holds[wall]) << rules[wall];
    EXPECT_EQ(std::get<double>(verdicts[wall].measured), measured[wall]) << rules[wall];
  }
}

TEST(Judge, ComparesAllOfTheStateHash) {
  std::string hash = hex(some_summary().state_hash);
  EXPECT_TRUE(verdict({.state_hash = hash}).holds);
  hash.back() = '1';
  const Expectation differing = verdict({.state_hash = hash});
  EXPECT_FALSE(differing.holds);
  EXPECT_EQ(differing.rule, "state_hash");
  EXPECT_EQ(std::get<std::string>(differing.measured), hex(some_summary().state_hash));
}

TEST(Judge, JudgesErrorsOnlyWhereTheyWereMeasured) {
  const Expect expect{.implementation_px_max = 1e-9, .truncation_px_max = 10.0, .energy_drift_rel_max = 0.01};
  EXPECT_TRUE(bounds_errors(expect));
  EXPECT_TRUE(judge(expect, some_summary()).empty());
  const RunErrors errors{.implementation_px = 1e-9, .truncation_px = 10.5, .energy_drift_rel = 0.001};
  const std::vector<Expectation> verdicts = judge(expect, some_summary(), errors);
  ASSERT_EQ(verdicts.size(), 3u);
  EXPECT_TRUE(verdicts[0].holds);
  EXPECT_FALSE(verdicts[1].holds);
  EXPECT_TRUE(verdicts[2].holds);
  EXPECT_EQ(verdicts[1].rule, "truncation_px_max");
  EXPECT_EQ(verdicts[1].wanted, "at most 10");
}

TEST(Judge, FindsAnErrorThatIsNoNumberBeyondAnyBound) {
  const RunErrors errors{.implementation_px = std::numeric_limits<double>::quiet_NaN()};
  EXPECT_FALSE(judge({.implementation_px_max = 1e300}, some_summary(), errors).front().holds);
}

TEST(Judge, KeepsTheOrderOfTheFormat) {
  Expect expect;
  expect.state_hash = std::string(32, '0');
  expect.contacts.ground = Interval{0, 0};
  expect.at_rest_since_s = Interval{0, 1};
  expect.finite = true;
  expect.in_bounds = true;
  expect.final_y_px = Interval{0, 1};
  std::string rules;
  for (const Expectation& expectation : judge(expect, some_summary())) rules += expectation.rule + " ";
  EXPECT_EQ(rules, "in_bounds finite final_y_px at_rest_since_s contacts/ground state_hash ");
}

TEST(BoundsErrors, DetectsEachOfThem) {
  EXPECT_FALSE(bounds_errors({.in_bounds = true}));
  EXPECT_TRUE(bounds_errors({.implementation_px_max = 0.0}));
  EXPECT_TRUE(bounds_errors({.truncation_px_max = 0.0}));
  EXPECT_TRUE(bounds_errors({.energy_drift_rel_max = 0.0}));
}

}  // namespace
}  // namespace hyrax
