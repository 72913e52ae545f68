#include "sim/reference/gsl_flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sim/reference/arc_solution.h"
#include "tests/sim/reference/test_run.h"

namespace hyrax {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distance_px(const Flight& a, const Flight& b) {
  return std::hypot(a.dx_px - b.dx_px, a.dy_px - b.dy_px);
}

// Flies both through these frames; how far apart they end, or infinity where the solver fails.
double apart_px(FlightSolver& solver, const std::vector<double>& frames_s, const Velocity& velocity) {
  ArcSolution closed((Model()));
  closed.start(velocity, true);
  solver.start(velocity, true);
  for (const double dt_s : frames_s) {
    closed.advance(dt_s);
    if (!solver.advance(dt_s)) return kInfinity;
  }
  return distance_px(solver.flight(), closed.matched());
}

const std::vector<double> kOneSecond(60, kFrame_s);
constexpr Velocity kVelocity{500.0, -900.0};

TEST(GslFlight, AgreesWithTheClosedForm) {
  GslFlight gsl;
  EXPECT_LT(apart_px(gsl, kOneSecond, kVelocity), 1e-11);
}

TEST(GslFlight, AgreesWhereEveryFrameHasItsOwnRate) {
  GslFlight gsl;
  EXPECT_LT(apart_px(gsl, {0.01, 0.02, 0.0, 0.005, 0.5, 0.5, 1e-6, 0.0, 0.0, 0.03}, kVelocity), 1e-11);
}

TEST(GslFlight, BeginsEveryArcAfresh) {
  GslFlight gsl;
  const double first_px = apart_px(gsl, kOneSecond, kVelocity);
  apart_px(gsl, {0.3, 0.2}, {-4000.0, 3000.0});
  EXPECT_EQ(apart_px(gsl, kOneSecond, kVelocity), first_px);
}

// A multistep method that goes on from the last arc's forces is off by hundreds of px; what is left
// after a restart is its global error, far above its tolerance for a step.
TEST(GslFlight, RestartsMultistepMethodsAtEveryArc) {
  GslFlight gsl({.stepper = GslStepper::msadams, .tolerance = 1e-10});
  apart_px(gsl, kOneSecond, kVelocity);
  EXPECT_LT(apart_px(gsl, kOneSecond, {-4000.0, 3000.0}), 1e-4);
}

class AnyStepper : public testing::TestWithParam<GslStepper> {};

// Each to the accuracy that its order and tolerance promise, a hundredfold for the steps it takes;
// the implicit Euler method needs a tolerance that it can reach.
TEST_P(AnyStepper, SolvesTheFlight) {
  const bool is_first_order = GetParam() == GslStepper::rk1imp;
  GslFlight gsl({.stepper = GetParam(), .tolerance = is_first_order ? 1e-3 : 1e-8});
  EXPECT_LT(apart_px(gsl, kOneSecond, kVelocity), is_first_order ? 10.0 : 1e-3);
}

INSTANTIATE_TEST_SUITE_P(GslFlight, AnyStepper,
                         testing::Values(GslStepper::rk2, GslStepper::rk4, GslStepper::rkf45,
                                         GslStepper::rkck, GslStepper::rk8pd, GslStepper::rk1imp,
                                         GslStepper::rk2imp, GslStepper::rk4imp, GslStepper::bsimp,
                                         GslStepper::msadams, GslStepper::msbdf),
                         [](const auto& test) {
                           return std::string(kGslStepperNames[static_cast<std::size_t>(test.param)]);
                         });

TEST(GslFlight, ComputesNothingInXThatIsNotAsked) {
  GslFlight gsl;
  gsl.start(kVelocity, false);
  ASSERT_TRUE(gsl.advance(kFrame_s));
  EXPECT_EQ(gsl.flight().dx_px, 0.0);
  EXPECT_EQ(gsl.flight().vx_px_per_s, 0.0);
}

TEST(GslFlight, RefusesAStateThatIsNotFinite) {
  GslFlight gsl;
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    gsl.start({500.0, bad}, true);
    EXPECT_FALSE(gsl.advance(kFrame_s)) << bad;
    gsl.start({bad, 0.0}, true);
    EXPECT_FALSE(gsl.advance(kFrame_s)) << bad;
  }
}

TEST(GslFlight, RefusesATimeThatIsNotFinite) {
  GslFlight gsl;
  for (const double bad : {kNaN, kInfinity, -kFrame_s}) {
    gsl.start(kVelocity, true);
    EXPECT_FALSE(gsl.advance(bad)) << bad;
    EXPECT_FALSE(gsl.advance(kFrame_s)) << "it has failed for good";
  }
}

TEST(GslFlight, RefusesAResultThatIsNotFinite) {
  GslFlight gsl;
  gsl.start({0.0, 1e308}, true);
  EXPECT_FALSE(gsl.advance(100.0));
}

TEST(GslFlight, IsAJudgeAtFullAccuracyAlone) {
  EXPECT_TRUE(GslFlight().is_judge());
  EXPECT_TRUE(GslFlight({.tolerance = 1e-13}).is_judge());
  EXPECT_FALSE(GslFlight({.tolerance = 1e-9}).is_judge());
  EXPECT_FALSE(GslFlight({.stepper = GslStepper::msadams}).is_judge());
}

TEST(DriftMeterWithGsl, FindsBothSolutionsOfEveryArcTogether) {
  GslFlight gsl;
  Measured measured;
  measure(fling(), measured, &gsl);
  for (const ArcErrors& arc : measured.arcs) {
    ASSERT_TRUE(arc.gsl_vs_closed_px);
    EXPECT_LT(*arc.gsl_vs_closed_px, 1e-9);
  }
  EXPECT_EQ(measured.summary.reference_faults, 0);
}

TEST(DriftMeterWithGsl, HasNoSuchFigureWithoutIt) {
  Measured measured;
  measure(fling(), measured);
  EXPECT_FALSE(measured.arcs.at(0).gsl_vs_closed_px);
  EXPECT_FALSE(measured.summary.gsl_vs_closed_px);
}

// Control: a judge that is off by 2e-9 px beyond 1e-13 of the coordinate.
struct LyingSolver final : FlightSolver {
  void start(const Velocity& velocity, bool solves_x) override { closed.start(velocity, solves_x); }
  bool advance(double dt_s) override {
    closed.advance(dt_s);
    return !fails;
  }
  Flight flight() const override {
    Flight flight = closed.matched();
    flight.dy_px += lie_px;
    return flight;
  }
  bool is_judge() const override { return judges; }

  ArcSolution closed{Model{}};
  double lie_px = 0.0;
  bool fails = false;
  bool judges = true;
};

TEST(DriftMeterWithGsl, CallsSolutionsThatLieApartAFaultOfTheReference) {
  LyingSolver solver;
  solver.lie_px = 2e-9;
  Measured measured;
  measure(fling(), measured, &solver);
  EXPECT_TRUE(measured.arcs.at(0).is_reference_fault);
  EXPECT_EQ(measured.summary.reference_faults, measured.summary.arcs);
  EXPECT_EQ(measured.summary.first_reference_fault_step, 0);
}

TEST(DriftMeterWithGsl, AllowsTheBoundBetweenThem) {
  LyingSolver solver;
  solver.lie_px = 1e-9;
  Measured measured;
  measure(fling(), measured, &solver);
  EXPECT_EQ(measured.summary.reference_faults, 0);
}

TEST(DriftMeterWithGsl, CallsAFailedSolverAFault) {
  LyingSolver solver;
  solver.fails = true;
  Measured measured;
  measure(fling(), measured, &solver);
  EXPECT_TRUE(measured.arcs.at(0).is_reference_fault);
  EXPECT_FALSE(measured.arcs.at(0).gsl_vs_closed_px);
}

TEST(DriftMeterWithGsl, DoesNotHoldALesserSolverToTheBound) {
  LyingSolver solver;
  solver.lie_px = 1.0;
  solver.judges = false;
  Measured measured;
  measure(fling(), measured, &solver);
  EXPECT_FALSE(measured.arcs.at(0).is_reference_fault);
  EXPECT_NEAR(*measured.arcs.at(0).gsl_vs_closed_px, 1.0, 1e-9);
}

}  // namespace
}  // namespace hyrax
