// Orders, fronts, answers, and the rules that a study must keep, each with a study that breaks it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/study/speed_error/speed_error.h"

namespace hyrax {
namespace {

// A clock that ticks once per reading: costs are meaningless, and no real time passes.
SpeedError some_study() {
  static const SpeedError study = [] {
    std::int64_t now_ns = 0;
    SpeedErrorOptions options;
    options.rates_hz = {15.0, 30.0, 60.0, 240.0, 960.0, 3840.0};
    options.cost.repetitions = 2;
    const std::vector<Problem> problems = study_problems();
    return study_speed_error({problems[0], problems[4]}, frame_methods(), options,
                             [now_ns]() mutable { return now_ns += 100'000; });
  }();
  return study;
}

bool is_broken(const SpeedError& study, const std::string& text) {
  const std::vector<std::string> broken = broken_rules(study);
  return std::any_of(broken.begin(), broken.end(),
                     [&](const std::string& rule) { return rule.find(text) != rule.npos; });
}

TEST(FittedOrder, IsTheSlopeOfALineThroughPowers) {
  EXPECT_NEAR(fitted_order({0.1, 0.05, 0.025}, {0.01, 0.0025, 0.000625}), 2.0, 1e-12);
  EXPECT_NEAR(fitted_order({1.0, 0.5}, {1.0, 2.0}), -1.0, 1e-12);
}

TEST(ParetoFront, HasThePointsThatNoOtherBeats) {
  EXPECT_EQ(pareto_front({1.0, 2.0, 3.0, 4.0}, {5.0, 6.0, 1.0, 1.0}),
            (std::vector<bool>{true, false, true, false}));
  EXPECT_EQ(pareto_front({1.0, 1.0}, {2.0, 1.0}), (std::vector<bool>{false, true}));
  EXPECT_EQ(pareto_front({1.0}, {std::nan("")}), std::vector<bool>{false});
}

TEST(SpeedErrorRules, HoldOfTheRealMethods) {
  EXPECT_EQ(broken_rules(some_study()), std::vector<std::string>{});
}

TEST(SpeedErrorRules, FindAMethodOfAnotherOrder) {
  SpeedError study = some_study();
  study.methods[3].accuracy = Convergent{2};  // Explicit Euler.
  EXPECT_TRUE(is_broken(study, "order is the analytic one"));
}

TEST(SpeedErrorRules, SayWhereWhatIsAllowedAndWhatWasFound) {
  SpeedError study = some_study();
  std::erase_if(study.orders, [](const OrderFit& fit) { return fit.problem == 0 && fit.method == 3; });
  EXPECT_EQ(
      broken_rules(study),
      std::vector<std::string>{"an order is fitted over three rates or more (euler, long-arc): must be 3 .. "
                               "inf (found 0)"});
}

TEST(SpeedErrorRules, FindAMethodThatFails) {
  SpeedError study = some_study();
  study.points[1].errors.is_failed = true;
  EXPECT_EQ(
      broken_rules(study),
      std::vector<std::string>{"the method cannot play the problem to its end (paper, long-arc, 30 Hz)"});
}

TEST(SpeedErrorRules, FindAnErrorThatIsNoNumber) {
  for (double MethodErrors::*const error :
       {&MethodErrors::position_px, &MethodErrors::velocity_px_per_s, &MethodErrors::end_px})
    for (const double value : {std::nan(""), HUGE_VAL}) {
      SpeedError study = some_study();
      study.points[1].errors.*error = value;
      EXPECT_TRUE(is_broken(study, "finite error"));
    }
}

TEST(SpeedErrorRules, FindAnOrderOfTooFewPoints) {
  SpeedError study = some_study();
  const auto of_euler = [](const OrderFit& fit) { return fit.problem == 0 && fit.method == 3; };
  std::find_if(study.orders.begin(), study.orders.end(), of_euler)->points = 2;
  EXPECT_TRUE(is_broken(study, "three rates or more"));
  std::erase_if(study.orders, of_euler);
  EXPECT_TRUE(is_broken(study, "three rates or more"));
}

TEST(SpeedErrorRules, FindAnExactMethodThatIsNot) {
  SpeedError study = some_study();
  for (WorkPoint& point : study.points)
    if (study.methods[point.method].name == "exact-flight") point.errors.position_px += 1e-8;
  EXPECT_TRUE(is_broken(study, "within rounding"));
}

TEST(SpeedErrorRules, FindImpactsInsideTheFrameThatAreNotExact) {
  SpeedError study = some_study();
  std::find_if(study.methods.begin(), study.methods.end(), [](const MethodKind& kind) {
    return kind.name == "exact-flight";
  })->accuracy = Exact{.meets_walls_exactly = true};
  EXPECT_TRUE(is_broken(study, "within rounding, px (exact-flight, fling"));
}

TEST(SpeedErrorRules, FindAPapersStepThatConverges) {
  SpeedError study = some_study();
  study.paper.back().model_px = 0.1;
  EXPECT_TRUE(is_broken(study, "leaves the fixed laws"));
}

TEST(SpeedErrorRules, FindATruncationThatIsNotItsClosedForm) {
  SpeedError study = some_study();
  study.paper[2].truncation_px_per_s *= 1.001;
  EXPECT_TRUE(is_broken(study, "closed form"));
  study = some_study();
  for (PaperErrors& paper : study.paper) paper.truncation_px *= paper.rate_hz;
  EXPECT_TRUE(is_broken(study, "first order"));
}

TEST(SpeedErrorRules, FindAPapersStepThatDiffersFromTheReference) {
  SpeedError study = some_study();
  study.points[0].errors.position_px *= 1.001;
  EXPECT_TRUE(is_broken(study, "as far from the fixed ODE"));
}

TEST(SpeedErrorRules, FindAnAdaptiveMethodThatMissesItsTolerance) {
  SpeedError study = some_study();
  study.methods.push_back({.name = "gsl-rk8pd-1e-12", .family = "GSL rk8pd", .accuracy = Adaptive{1e-12}});
  study.points.push_back({0, study.methods.size() - 1, 15.0, {}, {}});
  EXPECT_FALSE(is_broken(study, "as accurate as its tolerance asks"));
  study.points.back().errors.position_px = 1e-3;
  EXPECT_TRUE(is_broken(study, "as accurate as its tolerance asks"));
}

TEST(SpeedError, AnswersWithTheCheapestBelowAnError) {
  const SpeedError study = some_study();
  for (const CheapestBelow& answer : study.cheapest)
    for (std::size_t point = 0; point < study.points.size(); ++point) {
      const WorkPoint& p = study.points[point];
      if (p.problem != answer.problem || !(p.errors.position_px < answer.error_px)) continue;
      ASSERT_TRUE(answer.point);
      EXPECT_LE(study.points[*answer.point].cost.median_ns, p.cost.median_ns);
    }
}

}  // namespace
}  // namespace hyrax
