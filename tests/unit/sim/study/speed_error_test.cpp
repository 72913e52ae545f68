// Orders, fronts, answers, and the rules that a study must keep, each with a study that breaks it; its
// results where something was not measured or is no error at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/reference/model.h"
#include "sim/study/speed_error/speed_error.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/sim/study/clocks.h"

namespace hyrax {
namespace {

std::vector<Problem> problems(const Model& model = {}) { return study_problems(FixedLaws(model)); }

// On a clock that ticks once per reading: costs are meaningless, and no real time passes.
SpeedError some_study() {
  static const SpeedError study = [] {
    SpeedErrorOptions options;
    options.rates_hz = {15.0, 30.0, 60.0, 240.0, 960.0, 3840.0};
    options.cost.rounds = 1;
    options.band_rates_hz = {60.0};
    return study_speed_error(shipped_core(), {problems()[0], problems()[3]}, frame_methods(shipped_core()),
                             options, metered<steady_ns>);
  }();
  return study;
}

bool is_broken(const SpeedError& study, const std::string& text) {
  const std::vector<std::string> broken = broken_rules(study);
  return std::any_of(broken.begin(), broken.end(),
                     [&](const std::string& rule) { return rule.find(text) != rule.npos; });
}

// By hand: orders 1 and 3 between neighbours; the line of slope 2 leaves 1/3, -2/3, 1/3 octaves.
TEST(FittedPower, HasAStandardErrorAndARange) {
  const PowerFit fit = fitted_power({4.0, 2.0, 1.0}, {16.0, 8.0, 1.0});
  EXPECT_NEAR(fit.order, 2.0, 1e-12);
  EXPECT_NEAR(fit.standard_error, std::sqrt(1.0 / 3.0), 1e-12);
  EXPECT_NEAR(fit.least, 1.0, 1e-12);
  EXPECT_NEAR(fit.most, 3.0, 1e-12);
  EXPECT_TRUE(std::isnan(fitted_power({1.0, 0.5}, {1.0, 2.0}).standard_error));
}

Cost steady_cost(double time_ns) { return cost_of(std::vector(8, time_ns)); }

// Points of one problem at 60 Hz, with these costs and errors, ranked.
SpeedError ranked(const std::vector<Cost>& costs, const std::vector<double>& errors_px) {
  SpeedError study = some_study();
  study.points.resize(costs.size());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    study.points[i] = study.points.front();
    study.points[i].rate_hz = 60.0;
    study.points[i].cost = costs[i];
    study.points[i].errors.position_px = errors_px[i];
  }
  count_pairs(study);
  count_pairs(study);  // With the number of comparisons.
  mark_pareto(study);
  return study;
}

std::vector<bool> front_of(const std::vector<Cost>& costs, const std::vector<double>& errors_px) {
  std::vector<bool> front;
  for (const WorkPoint& point : ranked(costs, errors_px).points) front.push_back(point.is_pareto);
  return front;
}

TEST(Ranks, HoldInEveryProcessOrAreNone) {
  const Cost a = steady_cost(10.0), cheaper = steady_cost(9.0);
  Cost reversed = cheaper;
  reversed.processes_ns[3] = 10.5;  // In one process of eight.
  EXPECT_EQ(ranked({a, cheaper}, {1.0, 1.0}).ranked_pairs, 1);
  EXPECT_EQ(ranked({a, reversed}, {1.0, 1.0}).ranked_pairs, 0);
  EXPECT_EQ(ranked({a, Cost()}, {1.0, 1.0}).ranked_pairs, 0) << "not measured";
  const SpeedError study = ranked({a, cheaper, Cost()}, {1.0, 1.0, 1.0});
  EXPECT_EQ(study.comparisons, 3) << "whatever was measured";
  EXPECT_EQ(study.ranked_pairs, 1);
  EXPECT_TRUE(is_ranked_cheaper(study, study.points[1], study.points[0]));
}

// 8 processes decide 6 comparisons, 2^-7 * 6 = 0.047, and not 10.
TEST(Ranks, TakeMoreProcessesTheMorePairsAreCompared) {
  std::vector<Cost> costs;
  for (double time_ns = 1.0; time_ns <= 4.0; ++time_ns) costs.push_back(steady_cost(time_ns));
  EXPECT_EQ(ranked(costs, std::vector(4, 1.0)).ranked_pairs, 6);
  costs.push_back(steady_cost(5.0));
  EXPECT_EQ(ranked(costs, std::vector(5, 1.0)).ranked_pairs, 0);
}

TEST(Ranks, AreOfOneProblemAndOfComparablePoints) {
  SpeedError study = ranked(std::vector(4, steady_cost(1.0)), std::vector(4, 1.0));
  study.points[0].problem = 1;
  study.points[1].rate_hz = 30.0;
  count_pairs(study);
  EXPECT_EQ(study.comparisons, 1);
  study.points[2].errors.is_failed = true;
  count_pairs(study);
  EXPECT_EQ(study.comparisons, 0);
}

TEST(ParetoFront, KeepsWhatIsNotBeatenInEveryProcess) {
  Cost reversed = steady_cost(8.0);
  reversed.processes_ns.back() = 11.0;
  const Cost dearer = steady_cost(10.0), cheaper = steady_cost(9.0);
  EXPECT_EQ(front_of({dearer, reversed}, {2.0, 1.0}), (std::vector<bool>{true, true}));
  EXPECT_EQ(front_of({dearer, cheaper}, {2.0, 1.0}), (std::vector<bool>{false, true}));
  EXPECT_EQ(front_of({dearer, Cost()}, {2.0, 1.0}), (std::vector<bool>{true, false})) << "not measured";
  EXPECT_EQ(front_of({dearer, Cost()}, {std::nan(""), 1.0}), (std::vector<bool>(2, false)));
}

TEST(ParetoFront, AnErrorThatDiffersByLessThanAThousandthIsTheSame) {
  const std::vector<Cost> costs = {steady_cost(1252.0), steady_cost(817.0)};
  EXPECT_EQ(front_of(costs, {10.41029, 10.41031}), (std::vector<bool>{false, true}));
  EXPECT_EQ(front_of(costs, {10.39, 10.41}), (std::vector<bool>{true, true}));
}

TEST(ParetoFront, LastBitsDoNotDecideBetweenExactMethods) {
  const std::vector<Cost> costs = {steady_cost(1.0), steady_cost(2.0)};
  const double error_px = 0.25 * rounding_px(some_study().points.front().errors);
  EXPECT_EQ(front_of(costs, {2.0 * error_px, error_px}), (std::vector<bool>{true, false})) << "dearer";
  EXPECT_EQ(front_of(costs, {1.0, 0.5}), (std::vector<bool>{true, true}));
}

TEST(SpeedErrorRules, FindWhatBreaksThem) {
  constexpr std::size_t kEuler = 3, kExactFlight = 6, kExactImpacts = 8;
  struct Fault {
    const char* rule;
    void (*make)(SpeedError&);
  };
  const Fault faults[] = {
      {"the fitted order is the analytic one (euler, long-arc): ",
       [](SpeedError& study) { study.methods[kEuler].accuracy = Convergent{2}; }},
      {"an order is fitted over three rates or more (euler, long-arc): must be 3 .. inf (found 2)",
       [](SpeedError& study) {
         for (OrderFit& fit : study.orders)
           if (fit.problem == 0 && fit.method == kEuler) fit.points = 2;
       }},
      {"the error of an exact method is within rounding, px (exact-flight, long-arc, 15 Hz): must be 0 .. ",
       [](SpeedError& study) {
         for (WorkPoint& point : study.points)
           if (point.method == kExactFlight) point.errors.position_px += 1e-8;
       }},
      {"within rounding, px (exact-flight, fling",
       [](SpeedError& study) { study.methods[kExactFlight].accuracy = Exact{.meets_walls_exactly = true}; }},
      {"the paper's step leaves the fixed laws as its frames become shorter, px (at the highest rate): ",
       [](SpeedError& study) { study.paper.back().model_px = 0.1; }},
      {"the truncation is its closed form, as a ratio (paper, long-arc): must be 0.999999 .. ",
       [](SpeedError& study) {
         for (PaperErrors& paper : study.paper) paper.truncation_px *= paper.rate_hz;
       }},
      {"the paper's step is as far from the fixed ODE as the reference finds, as a ratio (paper, long-arc, ",
       [](SpeedError& study) { study.points[0].errors.position_px *= 1.001; }},
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

TEST(SpeedErrorRules, HoldWithOtherDragAndWithoutAny) {
  for (const auto& [air_drag, exact, convergence] :
       {std::tuple(0.97, "v' = g - k v with k = 1.828 1/s", "each frame takes 3 % of the speed"),
        std::tuple(1.0, "v' = g - k v with k = 0 1/s", "")}) {
    Constants constants = paper_constants();
    constants.air_drag = air_drag;
    Core core = listing_core(constants);
    core.name = "other_air";
    const SpeedError study = study_speed_error(
        core, {problems(Model(constants))[0]}, frame_methods(core),
        {.rates_hz = {15.0, 30.0, 60.0, 240.0, 960.0}, .cost = {.rounds = 1}}, metered<steady_ns>);
    EXPECT_EQ(broken_rules(study), std::vector<std::string>{}) << air_drag;
    EXPECT_NE(std::get<std::string>(speed_error_verdict(study, "m", false).text[1]).find(exact),
              std::string::npos);
    const std::vector<std::string> sentences = convergence_sentences(study);
    const std::string said = sentences.empty() ? "" : sentences.front();
    EXPECT_EQ(said.empty(), air_drag == 1.0);
    EXPECT_NE(said.find(convergence), std::string::npos) << said;
  }
}

TEST(SpeedErrorRules, SayWhereWhatIsAllowedAndWhatWasFoundOrThatAMethodFails) {
  SpeedError study = some_study();
  std::erase_if(study.orders, [](const OrderFit& fit) { return fit.problem == 0 && fit.method == 3; });
  EXPECT_EQ(
      broken_rules(study),
      std::vector<std::string>{"an order is fitted over three rates or more (euler, long-arc): must be 3 .. "
                               "inf (found 0)"});
  study = some_study();
  study.points[1].errors.is_failed = true;
  EXPECT_EQ(
      broken_rules(study),
      std::vector<std::string>{"the method cannot play the problem to its end (paper, long-arc, 30 Hz)"});
}

TEST(SpeedErrorRules, AllowAnAdaptiveMethodToGiveUpAndNotToMissItsTolerance) {
  SpeedError study = some_study();
  study.methods.push_back({.name = "gsl-rk8pd-1e-12", .family = "GSL rk8pd", .accuracy = Adaptive{1e-12}});
  study.probe.drift_rel = 1.0;  // Costs break no rule.
  study.points.push_back({0, study.methods.size() - 1, 60.0, {.is_failed = true}});
  EXPECT_EQ(broken_rules(study), std::vector<std::string>{});
  study.points.back().errors = {};
  EXPECT_EQ(broken_rules(study), std::vector<std::string>{});
  study.points.back().errors.position_px = 1e-3;
  EXPECT_TRUE(is_broken(study,
                        "rk8pd is as accurate as its tolerance asks, px (gsl-rk8pd-1e-12, long-arc, 60 Hz): "
                        "must be 0 .. 1e-06 (found 0.001)"));
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
  EXPECT_EQ(missing_orders_of_euler(), 1);
  for (WorkPoint& point : study.points)
    if (point.method == 3 && point.problem == 1 && point.rate_hz > 30.0) point.errors.position_px = 0.0;
  EXPECT_EQ(missing_orders_of_euler(), 0);
}

TEST(SpeedErrorRules, FindAnErrorThatIsNoNumber) {
  for (double MethodErrors::*const error :
       {&MethodErrors::position_px, &MethodErrors::velocity_px_per_s, &MethodErrors::end_px})
    for (const double value : {std::nan(""), HUGE_VAL}) {
      SpeedError study = some_study();
      study.points[1].errors.*error = value;
      EXPECT_TRUE(is_broken(study, "the method has a finite error (paper, long-arc, 30 Hz): "));
    }
}

TEST(SpeedError, RanksNothingOnAnUnsteadyClock) {
  SpeedErrorOptions options;
  options.rates_hz = {15.0, 60.0};
  const SpeedError study = study_speed_error(shipped_core(), {problems().front()},
                                             frame_methods(shipped_core()), options, metered<unsteady_ns>);
  EXPECT_FALSE(study.probe.is_steady());
  for (const WorkPoint& point : study.points) {
    EXPECT_FALSE(is_ranked(study, point) || point.is_pareto);
    EXPECT_TRUE(std::isnan(point.cost.time_ns.median));
  }
  for (const CheapestBelow& answer : study.cheapest) EXPECT_FALSE(answer.point || answer.paper_point);
}

TEST(MethodBands, OfAJitteredProblemHaveOtherSeeds) {
  EXPECT_NE(problems_like(problems()[5], 3)[2].jitter->seed, problems()[5].jitter->seed);
}

TEST(MethodBands, AHistogramCountsEveryErrorOnceFromTheSmallestToTheLargest) {
  using Bin = std::tuple<double, double, std::int64_t>;
  const auto bins_of = [](const std::vector<double>& errors) {
    std::vector<Bin> bins;
    for (const ErrorBin& bin : histogram_of(errors)) bins.emplace_back(bin.low, bin.high, bin.flings);
    return bins;
  };
  EXPECT_EQ(bins_of({0.5, 3.5, 1.0, 0.25, 3.5, kNotGiven}), (std::vector<Bin>{{0.0, 0.5, 1},
                                                                              {0.5, 1.0, 1},
                                                                              {1.0, 1.5, 1},
                                                                              {1.5, 2.0, 0},
                                                                              {2.0, 2.5, 0},
                                                                              {2.5, 3.0, 0},
                                                                              {3.0, 3.5, 0},
                                                                              {3.5, 4.0, 2}}));
  for (const double error : {0.0, 0.3}) {
    const std::vector<ErrorBin> bins = histogram_of({error, error});
    ASSERT_EQ(bins.size(), 1U) << error;
    EXPECT_EQ(bins[0].flings, 2) << error;
  }
  EXPECT_TRUE(histogram_of({kNotGiven}).empty());
  // Of a real problem: all flings are in it, and the median is where half of them are.
  const std::vector<MethodBands> all =
      method_bands(shipped_core(), problems()[4], {frame_methods(shipped_core()).front()}, {60.0});
  ASSERT_EQ(all.size(), 1U);
  std::int64_t flings = 0, below = 0;
  for (const ErrorBin& bin : all[0].energies) {
    flings += bin.flings;
    if (bin.high <= all[0].energy_rel.median) below += bin.flings;
  }
  EXPECT_EQ(flings, all[0].energy_rel.samples);
  EXPECT_LE(2 * below, flings);
}

TEST(MethodBands, ClaimOnlyWhatTheIntervalAllows) {
  EXPECT_EQ(nearness_text({65, 120}), "not decided by 120 flings");
  EXPECT_EQ(nearness_text({2145, 4000}), "it is nearer") << "4000 flings decide it";
  EXPECT_EQ(nearness_text({49, 120}), "it is farther");
  EXPECT_EQ(nearness_text({80, 120}), "it is nearer");
  EXPECT_EQ(nearness_text({0, 0}), "not decided by 0 flings");
}

// One flight, two methods at three rates each.
SpeedError small_study() {
  SpeedError study;
  study.problems = {problems().front()};
  const std::vector<MethodKind> methods = frame_methods(shipped_core());
  study.methods = {methods[0], methods[4]};
  for (std::size_t method = 0; method < 2; ++method)
    for (const double rate_hz : {30.0, 60.0, 240.0}) {
      WorkPoint point{0, method, rate_hz, {}, {}};
      point.errors.position_px = method == 0 ? rate_hz : 1.0 / rate_hz;
      point.cost = cost_of({9.0 * rate_hz, 10.0 * rate_hz, 12.0 * rate_hz});
      study.points.push_back(point);
    }
  study.least = {{0, 0, 30.0, 30.0}, {0, 1, 240.0, 1.0 / 240.0}};
  study.orders = {{{.order = -1.0, .standard_error = 0.04}, 0, 0, 3, 30.0, 240.0},
                  {{.order = 1.0, .standard_error = 0.0}, 0, 1, 3, 30.0, 240.0}};
  study.paper = {{.rate_hz = 60.0, .model_px = 9.8}, {.rate_hz = 240.0, .model_px = 42.0}};
  study.cost.processes = 20;
  return study;
}

// Of steppers of three tolerances: one of which they change nothing, one that becomes too slow for anyone.
void add_families(SpeedError& study) {
  for (const auto& [family, error_px, cost_ns] : {std::tuple("GSL rk8", 1e-5, 500.0),
                                                  {"GSL rk8", 1.5e-5, 400.0},
                                                  {"GSL rk8", 1e-5, 600.0},
                                                  {"GSL slow", 1.0, 1e4},
                                                  {"GSL slow", 1e-2, 1e5},
                                                  {"GSL slow", 1e-4, 1e9},
                                                  {"GSL slower", 1.0, 1e7}}) {
    study.methods.push_back({.name = family, .label = family, .family = family, .accuracy = Adaptive{}});
    WorkPoint point{0, study.methods.size() - 1, kRowRate_hz, {}, cost_of({cost_ns})};
    point.errors.position_px = error_px;
    study.points.push_back(point);
  }
}

// A failure or a cost that is not measured is a gap; a family is one named curve, a point where its tolerance
// does nothing, and ends where nobody uses it; 0 has a line of its own.
TEST(SpeedErrorResult, OfPartsOfAStudyIsTheOneApproved) {
  std::string text;
  const auto add = [&text](const std::string& what, const auto& alter) {
    SpeedError study = small_study();
    study.cheapest = {{.problem = 0, .error_px = 1e-9}};
    alter(study);
    Verdict verdict = speed_error_verdict(study, "some machine", false);
    verdict.broken.clear();  // Of invented numbers.
    text += what + "\n" + described(speed_error_figure(study, 0, "some machine")) + described(verdict) +
            described(speed_error_tables(study, "some machine").front());
  };
  add("all is measured", [](SpeedError&) {});
  add("a method gave up", [](SpeedError& study) { study.points[1].errors.is_failed = true; });
  add("a cost is not measured", [](SpeedError& study) { study.points[1].cost = {}; });
  add("costs are not measured", [](SpeedError& study) {
    study.comparisons = 1'300;
    study.ranked_pairs = 1'287;
    study.points[1].cost = study.points[3].cost = {};
    study.cheapest[0].as_cheap = {3};
  });
  add("the clock is unsteady", [](SpeedError& study) {
    study.probe.drift_rel = 0.4;
    for (WorkPoint& point : study.points) point.cost = {};
  });
  add("families of tolerances", add_families);
  add("no error at all", [](SpeedError& study) {
    study.points[4].errors.position_px = 0.0;
    study.points[5].errors.position_px = 2e-15;
    const Figure figure = speed_error_figure(study, 0, "m");
    for (const Plot& plot : std::get<std::vector<Plot>>(figure.body))
      EXPECT_DOUBLE_EQ(plot.y.zero_at, 1e-17) << "below the least error";
  });
  expect_approved("tests/unit/sim/study/approved/speed-error-of-parts.txt", text);
}

}  // namespace
}  // namespace hyrax
