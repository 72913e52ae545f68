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

void expect_verdict(const Expect& expect, const RunSummary& summary, const std::string& rule,
                    const std::string& wanted, const decltype(Expectation::measured)& measured, bool holds) {
  SCOPED_TRACE(rule + ": " + wanted);
  const std::vector<Expectation> verdicts = judge(expect, summary);
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_EQ(verdicts[0].rule, rule);
  EXPECT_EQ(verdicts[0].wanted, wanted);
  EXPECT_EQ(verdicts[0].measured, measured);
  EXPECT_EQ(verdicts[0].holds, holds);
}

TEST(Judge, SaysOfEachRuleWhetherItHoldsBothBoundsIncluded) {
  const RunSummary good = some_summary();
  RunSummary bad = good;
  bad.out_of_bounds_step = 12;
  bad.non_finite_step = 3;
  bad.at_rest_since_s.reset();
  expect_verdict({.in_bounds = true}, good, "in_bounds", "true", true, true);
  expect_verdict({.in_bounds = true}, bad, "in_bounds", "true", false, false);
  expect_verdict({.in_bounds = false}, good, "in_bounds", "false", true, false);
  expect_verdict({.in_bounds = false}, bad, "in_bounds", "false", false, true);
  expect_verdict({.finite = true}, good, "finite", "true", true, true);
  expect_verdict({.finite = true}, bad, "finite", "true", false, false);
  expect_verdict({.finite = false}, bad, "finite", "false", false, true);
  expect_verdict({.final_x_px = Interval{1069.25, 1069.25}}, good, "final_x_px", "1069.25", 1069.25, true);
  expect_verdict({.final_x_px = Interval{1069.25, 2000.0}}, good, "final_x_px", "1069.25 .. 2000", 1069.25,
                 true);
  expect_verdict({.final_x_px = Interval{0.0, 1069.25}}, good, "final_x_px", "0 .. 1069.25", 1069.25, true);
  expect_verdict({.final_x_px = Interval{1069.26, 2000.0}}, good, "final_x_px", "1069.26 .. 2000", 1069.25,
                 false);
  expect_verdict({.final_x_px = Interval{0.0, 1069.24}}, good, "final_x_px", "0 .. 1069.24", 1069.25, false);
  expect_verdict({.final_y_px = Interval{-kInfinity, 592.0}}, good, "final_y_px", "at most 592", 592.0, true);
  expect_verdict({.final_y_px = Interval{-kInfinity, 591.0}}, good, "final_y_px", "at most 591", 592.0,
                 false);
  expect_verdict({.at_rest_since_s = Interval{8.0, 8.5}}, good, "at_rest_since_s", "8 .. 8.5", 8.25, true);
  expect_verdict({.at_rest_since_s = Interval{-kInfinity, 8.0}}, good, "at_rest_since_s", "at most 8", 8.25,
                 false);
  expect_verdict({.at_rest_since_s = Interval{0.0, 1e300}}, bad, "at_rest_since_s", "0 .. 1e+300",
                 std::monostate{}, false);
  const std::string hash = hex(good.state_hash), other_hash = hash.substr(1) + "1";
  expect_verdict({.state_hash = hash}, good, "state_hash", hash, hash, true);
  expect_verdict({.state_hash = other_hash}, good, "state_hash", other_hash, hash, false);
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
  const std::string rules[] = {"implementation_px_max", "truncation_px_max", "energy_drift_rel_max"};
  for (std::size_t index = 0; index < 3; ++index) EXPECT_EQ(verdicts[index].rule, rules[index]);
  EXPECT_EQ(verdicts[1].wanted, "at most 10");
  EXPECT_EQ(std::get<double>(verdicts[1].measured), 10.5);
  EXPECT_FALSE(judge(expect, some_summary(), RunErrors{})[0].holds);  // Without an arc.
  const RunErrors unknown{.implementation_px = std::numeric_limits<double>::quiet_NaN()};
  EXPECT_FALSE(judge({.implementation_px_max = 1e300}, some_summary(), unknown).front().holds);
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

}  // namespace
}  // namespace hyrax
