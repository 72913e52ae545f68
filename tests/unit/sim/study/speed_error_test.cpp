// Orders, fronts, answers, and the rules that a study must keep, each with a study that breaks it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/core/shipped_core.h"
#include "sim/study/speed_error/speed_error.h"
#include "tests/unit/sim/study/clocks.h"

namespace hyrax {
namespace {

// On a clock that ticks once per reading: costs are meaningless, and no real time passes.
SpeedError some_study() {
  static const SpeedError study = [] {
    SpeedErrorOptions options;
    options.rates_hz = {15.0, 30.0, 60.0, 240.0, 960.0, 3840.0};
    options.cost.repetitions = 2;
    options.band_rates_hz = {60.0};
    const std::vector<Problem> problems = study_problems();
    return study_speed_error(shipped_core(), {problems[0], problems[4]}, frame_methods(shipped_core()),
                             options, steady_ns);
  }();
  return study;
}

bool is_broken(const SpeedError& study, const std::string& text) {
  const std::vector<std::string> broken = broken_rules(study);
  return std::any_of(broken.begin(), broken.end(),
                     [&](const std::string& rule) { return rule.find(text) != rule.npos; });
}

// The largest error over GSL's tolerances, and the smallest.
std::pair<double, double> end_errors_of(const std::string& family, double rate_hz) {
  const Problem arc = study_problems().front();
  double least_px = HUGE_VAL, most_px = 0.0;
  for (const MethodKind& kind : gsl_methods(shipped_core(), true)) {
    if (kind.family != family) continue;
    const double end_px =
        measure_errors(shipped_core(), arc, kind, stage_frames_s(arc, rate_hz), rate_hz).end_px;
    least_px = std::min(least_px, end_px);
    most_px = std::max(most_px, end_px);
  }
  return {least_px, most_px};
}

// Stopped at every row, a step of a frame is exact to rounding whatever the tolerance.
TEST(GslMethods, ToleranceSetsTheErrorOfTheEndOnly) {
  for (const char* family : {"GSL rkf45", "GSL rkck"}) {
    const auto [least_px, most_px] = end_errors_of(family, end_only_hz(study_problems().front()));
    EXPECT_GT(most_px, 1e-6) << family;
    EXPECT_LT(least_px, 1e-10) << family;
    EXPECT_LT(end_errors_of(family, kRowRate_hz).second, 1e-11) << family;
  }
}

TEST(FittedPower, IsTheSlopeOfALineThroughPowers) {
  const PowerFit fit = fitted_power({0.1, 0.05, 0.025}, {0.01, 0.0025, 0.000625});
  EXPECT_NEAR(fit.order, 2.0, 1e-12);
  EXPECT_NEAR(fit.standard_error, 0.0, 1e-12);
  EXPECT_NEAR(fitted_power({1.0, 0.5}, {1.0, 2.0}).order, -1.0, 1e-12);
  EXPECT_TRUE(std::isnan(fitted_power({1.0, 0.5}, {1.0, 2.0}).standard_error));
}

// By hand: orders 1 and 3 between neighbours; the line of slope 2 leaves 1/3, -2/3, 1/3 octaves.
TEST(FittedPower, HasAStandardErrorAndARange) {
  const PowerFit fit = fitted_power({4.0, 2.0, 1.0}, {16.0, 8.0, 1.0});
  EXPECT_NEAR(fit.order, 2.0, 1e-12);
  EXPECT_NEAR(fit.standard_error, std::sqrt(1.0 / 3.0), 1e-12);
  EXPECT_NEAR(fit.least, 1.0, 1e-12);
  EXPECT_NEAR(fit.most, 3.0, 1e-12);
}

std::vector<Cost> steady_costs(const std::vector<double>& times_ns) {
  std::vector<Cost> costs;
  for (const double time_ns : times_ns) costs.push_back(cost_of({time_ns, time_ns, time_ns}));
  return costs;
}

TEST(ParetoFront, HasThePointsThatNoOtherBeats) {
  EXPECT_EQ(pareto_front(steady_costs({1.0, 2.0, 3.0, 4.0}), {5.0, 6.0, 1.0, 1.0}),
            (std::vector<bool>{true, false, true, false}));
  EXPECT_EQ(pareto_front(steady_costs({1.0}), {std::nan("")}), std::vector<bool>{false});
}

TEST(ParetoFront, KeepsWhatIsBeatenWithinTheNoiseOnly) {
  std::vector<Cost> costs = steady_costs({10.0, 10.0});
  costs[1] = cost_of({8.0, 11.0, 9.0});
  EXPECT_EQ(pareto_front(costs, {2.0, 1.0}), (std::vector<bool>{true, true}));
  costs[1] = cost_of({8.0, 9.5, 9.0});
  EXPECT_EQ(pareto_front(costs, {2.0, 1.0}), (std::vector<bool>{false, true}));
  costs[1] = {};
  EXPECT_EQ(pareto_front(costs, {2.0, 1.0}), (std::vector<bool>{true, false})) << "not measured";
}

TEST(ParetoFront, LastBitsDoNotDecideBetweenExactMethods) {
  SpeedError study = some_study();
  study.points.resize(2);
  for (WorkPoint& point : study.points) {
    point = study.points.front();
    point.rate_hz = 60.0;
  }
  for (const double error_px : {0.25 * rounding_px(study.points[1].errors), 0.5}) {
    study.points[0].cost = steady_costs({1.0}).front();
    study.points[1].cost = steady_costs({2.0}).front();
    study.points[0].errors.position_px = 2.0 * error_px;
    study.points[1].errors.position_px = error_px;
    mark_pareto(study);
    EXPECT_TRUE(study.points[0].is_pareto);
    EXPECT_EQ(study.points[1].is_pareto, error_px == 0.5) << "as exact, and dearer";
  }
}

TEST(SpeedErrorRules, HoldOfTheRealMethods) {
  EXPECT_EQ(broken_rules(some_study()), std::vector<std::string>{});
}

TEST(SpeedErrorRules, FindWhatBreaksThem) {
  constexpr std::size_t kEuler = 3, kExactFlight = 6, kExactImpacts = 7;
  struct Fault {
    const char* rule;
    void (*make)(SpeedError&);
  };
  const Fault faults[] = {
      {"order is the analytic one",
       [](SpeedError& study) { study.methods[kEuler].accuracy = Convergent{2}; }},
      {"three rates or more",
       [](SpeedError& study) {
         for (OrderFit& fit : study.orders)
           if (fit.problem == 0 && fit.method == kEuler) fit.points = 2;
       }},
      {"within rounding",
       [](SpeedError& study) {
         for (WorkPoint& point : study.points)
           if (point.method == kExactFlight) point.errors.position_px += 1e-8;
       }},
      {"within rounding, px (exact-flight, fling",
       [](SpeedError& study) { study.methods[kExactFlight].accuracy = Exact{.meets_walls_exactly = true}; }},
      {"leaves the fixed laws", [](SpeedError& study) { study.paper.back().model_px = 0.1; }},
      {"closed form", [](SpeedError& study) { study.paper[2].truncation_px_per_s *= 1.001; }},
      {"first order",
       [](SpeedError& study) {
         for (PaperErrors& paper : study.paper) paper.truncation_px *= paper.rate_hz;
       }},
      {"as far from the fixed ODE", [](SpeedError& study) { study.points[0].errors.position_px *= 1.001; }},
      {"flings in which the error of an exact method is more than rounding",
       [](SpeedError& study) {
         study.bands.back().method = kExactImpacts;
         study.bands.back().beyond_rounding = 1;
       }},
  };
  for (const auto& [rule, make] : faults) {
    SpeedError study = some_study();
    make(study);
    EXPECT_TRUE(is_broken(study, rule)) << rule;
  }
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

TEST(SpeedErrorRules, AllowAnAdaptiveMethodToGiveUp) {
  SpeedError study = some_study();
  study.methods.push_back({.name = "gsl-rk1imp-1e-14", .family = "GSL rk1imp", .accuracy = Adaptive{1e-14}});
  study.points.push_back({0, study.methods.size() - 1, 60.0, {.is_failed = true}});
  EXPECT_EQ(broken_rules(study), std::vector<std::string>{});
}

// The order of a method that is accurate to rounding at all rates but two cannot be fitted.
TEST(SpeedErrorRules, WantNoOrderOfRounding) {
  SpeedError study = some_study();
  study.problems.insert(study.problems.begin(), study.problems.front());
  study.paper.clear();
  for (WorkPoint& point : study.points) ++point.problem;
  for (OrderFit& fit : study.orders) ++fit.problem;
  for (MethodBands& bands : study.bands) ++bands.problem;
  std::erase_if(study.orders, [](const OrderFit& fit) { return fit.method == 3 && fit.problem == 1; });
  const auto missing_orders_of_euler = [&study] {
    const std::vector<std::string> broken = broken_rules(study);
    return std::count_if(broken.begin(), broken.end(), [](const std::string& rule) {
      return rule.find("three rates or more (euler, long-arc)") != rule.npos;
    });
  };
  EXPECT_EQ(missing_orders_of_euler(), 2) << "of both problems";
  for (WorkPoint& point : study.points)
    if (point.method == 3 && point.problem == 1 && point.rate_hz > 30.0) point.errors.position_px = 0.0;
  EXPECT_EQ(missing_orders_of_euler(), 1) << "of the first alone";
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

TEST(SpeedErrorRules, FindAnAdaptiveMethodThatMissesItsTolerance) {
  SpeedError study = some_study();
  study.methods.push_back({.name = "gsl-rk8pd-1e-12", .family = "GSL rk8pd", .accuracy = Adaptive{1e-12}});
  study.points.push_back({0, study.methods.size() - 1, 60.0, {}, {}});
  EXPECT_FALSE(is_broken(study, "as accurate as its tolerance asks"));
  study.points.back().errors.position_px = 1e-3;
  EXPECT_TRUE(is_broken(study, "as accurate as its tolerance asks"));
}

TEST(SpeedErrorRules, JudgeNoCosts) {
  SpeedError study = some_study();
  for (WorkPoint& point : study.points) point.cost = {};
  study.probe.drift_rel = 1.0;
  EXPECT_EQ(broken_rules(study), std::vector<std::string>{});
}

TEST(SpeedError, RanksNothingOnAnUnsteadyClock) {
  SpeedErrorOptions options;
  options.rates_hz = {15.0, 60.0};
  const SpeedError study = study_speed_error(shipped_core(), {study_problems().front()},
                                             frame_methods(shipped_core()), options, unsteady_ns);
  EXPECT_FALSE(study.probe.is_steady());
  for (const WorkPoint& point : study.points) {
    EXPECT_FALSE(is_ranked(study, point) || point.is_pareto);
    EXPECT_TRUE(std::isnan(point.cost.time_ns.median));
  }
  for (const CheapestBelow& answer : study.cheapest) EXPECT_FALSE(answer.point || answer.paper_point);
}

TEST(SpeedError, RanksWhatGivesSixtyRowsASecondAndNotTheTruth) {
  const SpeedError study = some_study();
  for (const WorkPoint& point : study.points) {
    const bool is_reference = study.methods[point.method].name == "event-driven";
    EXPECT_EQ(is_ranked(study, point), point.rate_hz >= 60.0 && !is_reference);
    EXPECT_TRUE(!is_reference || point.rate_hz == 60.0) << "frames are nothing to it";
  }
}

TEST(SpeedError, AnswersWithTheCheapestBelowAnErrorAndWhatIsAsCheap) {
  const SpeedError study = some_study();
  for (const CheapestBelow& answer : study.cheapest)
    for (std::size_t point = 0; point < study.points.size(); ++point) {
      const WorkPoint& p = study.points[point];
      if (p.problem != answer.problem || !is_ranked(study, p) || !(p.errors.position_px < answer.error_px))
        continue;
      ASSERT_TRUE(answer.point);
      const Cost& best = study.points[*answer.point].cost;
      EXPECT_LE(best.time_ns.median, p.cost.time_ns.median);
      const bool is_named =
          std::find(answer.as_cheap.begin(), answer.as_cheap.end(), point) != answer.as_cheap.end();
      EXPECT_EQ(is_named, point != *answer.point && !is_cheaper(best, p.cost));
    }
}

// A run takes 1 us to set up and 1 us a frame, and the clock is read before and after.
TEST(SpeedError, TakesTheSetUpOffTheCostOfFrames) {
  struct Timed final : Method {
    explicit Timed(std::int64_t& clock_ns) : now_ns(clock_ns) {}
    void start(const State& from, const Bounds&) override {
      state = from;
      now_ns += 1'000;
    }
    bool play(std::span<const double> frames_s) override {
      now_ns += 1'000 * std::ssize(frames_s);
      return true;
    }
    State motion() const override { return state; }
    std::int64_t& now_ns;
    State state;
  };
  std::int64_t now_ns = 0;
  const MethodKind timed{.name = "paper", .make = [&now_ns] { return std::make_unique<Timed>(now_ns); }};
  SpeedErrorOptions options;
  options.rates_hz = {60.0, 120.0};
  const SpeedError study = study_speed_error(shipped_core(), {study_problems()[1]}, {timed}, options,
                                             [&now_ns] { return now_ns; });
  ASSERT_EQ(study.set_ups.size(), 1u);
  EXPECT_EQ(study.set_ups[0].cost.time_ns.median, 1'000.0);
  EXPECT_DOUBLE_EQ(study.points[0].cost.time_ns.median, 60'000.0) << "12 frames in a fifth of a second";
  EXPECT_DOUBLE_EQ(study.points[1].cost.time_ns.median, 120'000.0);
}

TEST(MethodBands, AreOverManyFlingsOfWhichTheFirstIsTheProblem) {
  const Problem fling = study_problems()[4];
  const std::vector<Problem> flings = problems_like(fling, kBandFlings, kBandSeed);
  ASSERT_GE(flings.size(), 100u);
  EXPECT_TRUE(same_bits(flings[0].start, fling.start));
  for (const Problem& like : flings) {
    EXPECT_LE(std::fabs(like.start.x_px - fling.start.x_px), kBandStart_px);
    EXPECT_LE(std::fabs(like.start.vx_px_per_s / fling.start.vx_px_per_s - 1.0), kBandSpeed_rel);
    EXPECT_TRUE(&like == &flings[0] || !same_bits(like.start, fling.start));
  }
  EXPECT_NE(problems_like(study_problems()[6], 3, kBandSeed)[2].jitter->seed,
            study_problems()[6].jitter->seed);
}

TEST(MethodBands, AreThoseOfTheErrorsOneByOne) {
  const Problem fling = study_problems()[4];
  const std::vector<MethodKind> methods = frame_methods(shipped_core());
  const std::vector<MethodBands> bands = method_bands(shipped_core(), fling, methods, {60.0});
  ASSERT_EQ(bands.size(), methods.size() - 1) << "all but the reference";
  std::vector<double> ends_px;
  std::int64_t nearer = 0;
  for (const Problem& like : problems_like(fling, kBandFlings, kBandSeed)) {
    const auto end_px = [&](std::size_t method) {
      return measure_errors(shipped_core(), like, methods[method], stage_frames_s(like, 60.0), 60.0).end_px;
    };
    ends_px.push_back(end_px(6));
    if (end_px(6) < end_px(0)) ++nearer;
  }
  EXPECT_EQ(bands[6].end_px.median, quantile(ends_px, 0.5));
  EXPECT_EQ(bands[6].end_px.low, quantile(ends_px, 0.1));
  EXPECT_EQ(bands[6].nearer.count, nearer);
  EXPECT_EQ(bands[7].nearer.count, kBandFlings) << "exact impacts";
  EXPECT_EQ(bands[7].beyond_rounding, 0);
  EXPECT_EQ(bands[0].nearer.count, 0) << "than itself";
}

TEST(MethodBands, ClaimOnlyWhatTheIntervalAllows) {
  EXPECT_EQ(nearness_text({65, 120}), "not decided by 120 flings");
  EXPECT_EQ(nearness_text({2145, 4000}), "it is nearer") << "4000 flings decide it";
  EXPECT_EQ(nearness_text({49, 120}), "it is farther");
  EXPECT_EQ(nearness_text({80, 120}), "it is nearer");
  EXPECT_EQ(nearness_text({0, 0}), "not decided by 0 flings");
}

}  // namespace
}  // namespace hyrax
