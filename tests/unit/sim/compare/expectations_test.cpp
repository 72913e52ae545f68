// The expectations of a scenario, judged rule by rule.
#include "sim/compare/expectations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace hyrax {
namespace {

RunSummary some_summary() {
  RunSummary summary;
  summary.contacts = {1, 3, 0, 21};
  summary.final.x_px = 1069.25;
  summary.final.y_px = 592.0;
  summary.at_rest_since_s = 8.25;
  summary.state_hash = {0xab, 0xcd};
  return summary;
}

std::ostream& operator<<(std::ostream& out, std::monostate) { return out << "nothing"; }

// Such as "final_x_px: 0 .. 1070, found 1069.25: holds", each in a line.
std::string judged(const Expect& expect, const RunSummary& summary,
                   const std::optional<RunErrors>& errors = {}) {
  std::ostringstream text;
  text << std::boolalpha;
  for (const Expectation& each : judge(expect, summary, errors)) {
    text << each.rule << ": " << each.wanted << ", found ";
    std::visit([&](const auto& measured) { text << measured; }, each.measured);
    text << (each.holds ? ": holds\n" : ": broken\n");
  }
  return text.str();
}

TEST(Judge, SaysOfEachRuleWhetherItHoldsBothBoundsIncluded) {
  const RunSummary good = some_summary();
  RunSummary bad = good;
  bad.out_of_bounds_step = 12;
  bad.non_finite_step = 3;
  bad.at_rest_since_s.reset();
  const std::string hash = hex(good.state_hash), other_hash = hash.substr(1) + "1";
  const struct {
    Expect expect;
    const RunSummary& summary;
    std::string verdict;
  } cases[] = {
      {{.in_bounds = true}, good, "in_bounds: true, found true: holds"},
      {{.in_bounds = true}, bad, "in_bounds: true, found false: broken"},
      {{.in_bounds = false}, good, "in_bounds: false, found true: broken"},
      {{.in_bounds = false}, bad, "in_bounds: false, found false: holds"},
      {{.finite = true}, good, "finite: true, found true: holds"},
      {{.finite = true}, bad, "finite: true, found false: broken"},
      {{.finite = false}, bad, "finite: false, found false: holds"},
      {{.final_x_px = Interval{1069.25, 1069.25}}, good, "final_x_px: 1069.25, found 1069.25: holds"},
      {{.final_x_px = Interval{1069.25, 2e3}}, good, "final_x_px: 1069.25 .. 2000, found 1069.25: holds"},
      {{.final_x_px = Interval{0.0, 1069.25}}, good, "final_x_px: 0 .. 1069.25, found 1069.25: holds"},
      {{.final_x_px = Interval{1069.26, 2e3}}, good, "final_x_px: 1069.26 .. 2000, found 1069.25: broken"},
      {{.final_x_px = Interval{0.0, 1069.24}}, good, "final_x_px: 0 .. 1069.24, found 1069.25: broken"},
      {{.final_y_px = Interval{-HUGE_VAL, 592.0}}, good, "final_y_px: at most 592, found 592: holds"},
      {{.final_y_px = Interval{-HUGE_VAL, 591.0}}, good, "final_y_px: at most 591, found 592: broken"},
      {{.at_rest_since_s = Interval{8.0, 8.5}}, good, "at_rest_since_s: 8 .. 8.5, found 8.25: holds"},
      {{.at_rest_since_s = Interval{-HUGE_VAL, 8.0}}, good, "at_rest_since_s: at most 8, found 8.25: broken"},
      {{.at_rest_since_s = Interval{0.0, 1e300}},
       bad,
       "at_rest_since_s: 0 .. 1e+300, found nothing: broken"}};
  for (const auto& [expect, summary, verdict] : cases) EXPECT_EQ(judged(expect, summary), verdict + "\n");
  EXPECT_EQ(judged({.state_hash = hash}, good), "state_hash: " + hash + ", found " + hash + ": holds\n");
  EXPECT_EQ(judged({.state_hash = other_hash}, good),
            "state_hash: " + other_hash + ", found " + hash + ": broken\n");
}

TEST(Judge, CountsTheContactsOfEachWallAndKeepsTheOrderOfTheFormat) {
  Expect expect;
  expect.state_hash = std::string(32, '0');
  expect.contacts = {Interval{1, 1}, Interval{2, 4}, Interval{1, 1}, Interval{22, 30}};
  expect.at_rest_since_s = Interval{0, 1};
  expect.finite = true;
  expect.in_bounds = true;
  expect.final_y_px = Interval{0, 1};
  EXPECT_EQ(judged(expect, some_summary()),
            "in_bounds: true, found true: holds\n"
            "finite: true, found true: holds\n"
            "final_y_px: 0 .. 1, found 592: broken\n"
            "at_rest_since_s: 0 .. 1, found 8.25: broken\n"
            "contacts/left: 1, found 1: holds\n"
            "contacts/right: 2 .. 4, found 3: holds\n"
            "contacts/top: 1, found 0: broken\n"
            "contacts/ground: 22 .. 30, found 21: broken\n"
            "state_hash: " +
                *expect.state_hash + ", found " + hex(some_summary().state_hash) + ": broken\n");
}

TEST(Judge, JudgesErrorsOnlyWhereTheyWereMeasured) {
  const Expect expect{.implementation_px_max = 1e-9, .truncation_px_max = 10.0, .energy_drift_rel_max = 0.01};
  EXPECT_TRUE(bounds_errors(expect));
  EXPECT_EQ(judged(expect, some_summary()), "");
  const RunErrors errors{.implementation_px = 1e-9, .truncation_px = 10.5, .energy_drift_rel = 0.001};
  EXPECT_EQ(judged(expect, some_summary(), errors),
            "implementation_px_max: at most 1e-09, found 1e-09: holds\n"
            "truncation_px_max: at most 10, found 10.5: broken\n"
            "energy_drift_rel_max: at most 0.01, found 0.001: holds\n");
  const RunErrors unknown{.implementation_px = std::numeric_limits<double>::quiet_NaN()};
  EXPECT_FALSE(judge({.implementation_px_max = 1e300}, some_summary(), RunErrors{})[0].holds) << "no arc";
  EXPECT_FALSE(judge({.implementation_px_max = 1e300}, some_summary(), unknown)[0].holds);
}

}  // namespace
}  // namespace hyrax
