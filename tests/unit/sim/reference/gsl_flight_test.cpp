// The second solution, and controls: mistakes in the closed forms that it notices.
#include "sim/reference/gsl_flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <tuple>
#include <vector>

#include "sim/reference/arc_meter.h"
#include "sim/reference/arc_solution.h"
#include "tests/unit/sim/reference/test_run.h"

namespace hyrax {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Flies both through these frames; how far apart they end, or infinity where the solver fails.
double apart_px(FlightSolver& solver, const std::vector<double>& frames_s, const Velocity& velocity) {
  ArcSolution closed((Model()));
  closed.start(velocity, true);
  solver.start(velocity, true);
  State solved;
  for (const double dt_s : frames_s) {
    closed.advance(dt_s);
    const std::optional<State> next = solver.advance(dt_s);
    if (!next) return kInfinity;
    solved = *next;
  }
  const State exact = closed.matched();
  return std::hypot(solved.x_px - exact.x_px, solved.y_px - exact.y_px);
}

const std::vector<double> kOneSecond(60, kFrame_s);
constexpr Velocity kVelocity{500.0, -900.0};

// A multistep method that goes on from the last arc's forces is off by hundreds of px; what is left
// after a restart is its global error, far above its tolerance for a step.
TEST(GslFlight, RestartsMultistepMethodsAtEveryArc) {
  const auto gsl = gsl_flight({.stepper = GslStepper::msadams, .tolerance = 1e-10});
  apart_px(*gsl, kOneSecond, kVelocity);
  EXPECT_LT(apart_px(*gsl, kOneSecond, {-4000.0, 3000.0}), 1e-4);
}

// 250 s at 240 Hz, the last 240 of them at the final speed, where each frame rounds like the one before:
// in plain double the sum is off by 5e-7 px at 1e6 px.
TEST(GslFlight, KeepsItsDigitsOverManyFrames) {
  const auto gsl = gsl_flight();
  EXPECT_LT(apart_px(*gsl, std::vector<double>(60'000, 1.0 / 240.0), kVelocity), 1e-8);
  EXPECT_LT(apart_px(*gsl, std::vector<double>(100'000, 1e-3), kVelocity), 1e-8);
}

// The two share nothing: Halley's steps on the closed form, and Brent's method on GSL's solution.
TEST(GslFlight, FindsTheTimeOfImpactAfterAllSpeedIsLost) {
  const Approach fall{-300.0, 0.0, 1200.0, 100.0};
  EXPECT_NEAR(gsl_flight()->time_of_impact(fall, 100.0).value().t_s, time_of_impact(fall, 100.0).value().t_s,
              1e-10);
}

TEST(GslFlight, CrossesAWallAtOnceWhenOnItAndAtNoTimeForNan) {
  const auto gsl = gsl_flight();
  EXPECT_EQ(gsl->time_of_impact({0.0, 10.0, 0.0, 0.06}, 1.0)->t_s, 0.0);
  EXPECT_EQ(gsl->time_of_impact({0.0, 0.0, 1200.0, 0.06}, 1.0)->t_s, 0.0);
  EXPECT_FALSE(gsl->time_of_impact({0.0, -10.0, 0.0, 0.06}, 1.0));
  EXPECT_TRUE(std::isnan(gsl->time_of_impact({kNaN, 10.0, 0.0, 0.06}, 1.0)->t_s));
}

// As accurate as its order and a tolerance that it can reach; the study speed-error has the other methods.
TEST(GslFlight, SolvesTheFlightByTheImplicitEulerMethod) {
  const auto gsl = gsl_flight({.stepper = GslStepper::rk1imp, .tolerance = 1e-3});
  EXPECT_LT(apart_px(*gsl, kOneSecond, kVelocity), 10.0);
}

TEST(GslFlight, RefusesAStateATimeAndAResultThatAreNotFinite) {
  const auto gsl = gsl_flight();
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    gsl->start({500.0, bad}, true);
    EXPECT_FALSE(gsl->advance(kFrame_s)) << bad;
    gsl->start({bad, 0.0}, true);
    EXPECT_FALSE(gsl->advance(kFrame_s)) << bad;
  }
  for (const double bad : {kNaN, kInfinity, -kFrame_s}) {
    gsl->start(kVelocity, true);
    EXPECT_FALSE(gsl->advance(bad)) << bad;
    EXPECT_FALSE(gsl->advance(kFrame_s)) << "it has failed for good";
  }
  gsl->start({0.0, 1e308}, true);
  EXPECT_FALSE(gsl->advance(100.0));
}

// Control: GSL's answers with a change.
struct AlteredSolver final : FlightSolver {
  void start(const Velocity& velocity, bool solves_x) override { gsl->start(velocity, solves_x); }
  std::optional<State> advance(double dt_s) override {
    std::optional<State> flight = gsl->advance(dt_s);
    if (flight) flight->y_px += off_px;
    return fails ? std::nullopt : flight;
  }
  std::optional<Position> model(double t_s) override { return gsl->model(t_s); }
  std::optional<Impact> time_of_impact(const Approach& approach, double t_max_s) override {
    return gsl->time_of_impact(approach, t_max_s);
  }

  std::unique_ptr<FlightSolver> gsl = gsl_flight();
  double off_px = 0.0;
  bool fails = false;
};

TEST(DriftMeterWithGsl, HoldsItToTheBoundAndCallsAFailedOneAFault) {
  const struct {
    double off_px;
    bool fails;
    std::string_view fault;
  } cases[] = {
      {0.9e-9, false, ""}, {2e-9, false, "position differs"}, {0.0, true, "the second solver failed"}};
  for (const auto& [off_px, fails, fault] : cases) {
    AlteredSolver solver;
    std::tie(solver.off_px, solver.fails) = std::tie(off_px, fails);
    Measured measured;
    measure(fling(), measured, &solver);
    EXPECT_EQ(measured.arcs.at(0).reference_fault, fault);
    EXPECT_EQ(measured.arcs.at(0).gsl_vs_closed_px.has_value(), !fails);
    EXPECT_NEAR(measured.arcs.at(0).gsl_vs_closed_px.value_or(0.0), off_px, 1e-9);
    EXPECT_EQ(measured.summary.first_reference_fault, fault);
    EXPECT_EQ(measured.summary.reference_faults >= measured.summary.arcs, !fault.empty());
    EXPECT_EQ(measured.summary.first_reference_fault_step.has_value(), !fault.empty());
    EXPECT_EQ(measured.summary.first_reference_fault_step.value_or(0), 0);
  }
}

constexpr double kHeight_px = 500.0;

// What the closed forms say of an arc, as it is handed to the check; a test changes it.
struct Closed {
  std::function<void(State&)> flight = [](State&) {};
  double height_sign = 1.0;       // In the energy.
  double gain_height_sign = 1.0;  // In its change.
  double model_rate_hz = 60.0;
  double air_drag = 0.999;
  double thrown_px_per_s = -600.0;
  double clamped_dt_s = kFrame_s;
  std::function<void(std::optional<Impact>&)> impact = [](std::optional<Impact>&) {};
};

double kinetic(const State& flight) {
  return 0.5 * (flight.vx_px_per_s * flight.vx_px_per_s + flight.vy_px_per_s * flight.vy_px_per_s);
}

// A throw up from the floor and to the right, until it comes down again.
std::string_view fault_of(const Closed& closed) {
  ArcStart start{.row = {.y_px = kHeight_px, .vx_px_per_s = 300.0, .vy_px_per_s = closed.thrown_px_per_s},
                 .bounds = {1000.0, kHeight_px}};
  Model model;
  model.air_drag = closed.air_drag;
  const auto gsl = gsl_flight({}, model);
  ReferenceCheck check(model, *gsl);
  model.model_rate_hz = closed.model_rate_hz;
  ArcSolution solution(model);
  WallWatch walls(model.gravity_px_per_s2, solution.log_air_drag(), time_of_impact);
  const State first{0.0, 0.0, start.row.vx_px_per_s, start.row.vy_px_per_s};
  solution.start({first.vx_px_per_s, first.vy_px_per_s}, true);
  walls.start(start);
  check.start(start, true, kinetic(first));
  for (int frame = 0; frame < 59; ++frame) {
    solution.advance(kFrame_s);
    State flight = solution.matched();
    closed.flight(flight);
    const double rise = -model.gravity_px_per_s2 * flight.y_px;
    check.check_row({flight, kinetic(flight) + closed.height_sign * rise,
                     kinetic(flight) - kinetic(first) + closed.gain_height_sign * rise},
                    kFrame_s, solution.elapsed_s());
    walls.add(flight, kFrame_s, solution.elapsed_s());
  }
  check.check_model(solution.model(), solution.elapsed_s());
  std::optional<Impact> impact = walls.impact(Wall::ground, closed.clamped_dt_s);
  closed.impact(impact);
  check.check_impact(Wall::ground, closed.clamped_dt_s, impact);
  return check.fault(kHeight_px);
}

TEST(ReferenceCheck, AgreesWithTheClosedForms) {
  for (const double air_drag : {0.5, 0.9, 0.99, 0.997, 0.998, 0.999, 1.0 - 1e-5, 1.0 - 1e-9, 1.0}) {
    EXPECT_EQ(fault_of({.air_drag = air_drag}), "") << air_drag;
    EXPECT_EQ(fault_of({.height_sign = 1.0 + 1e-6, .air_drag = air_drag}), "energy differs") << air_drag;
  }
}

TEST(ReferenceCheck, NoticesEachMistake) {
  EXPECT_EQ(fault_of({.flight = [](State& flight) { flight.y_px = kNaN; }}), "position differs");
  EXPECT_EQ(fault_of({.flight = [](State& flight) { flight.x_px = kNaN; }}), "position differs");
  // Of gravity alone: a thousandth of what the speed has gained.
  const auto gains_more = [](State& flight) { flight.vy_px_per_s += 0.001 * (flight.vy_px_per_s + 600.0); };
  EXPECT_EQ(fault_of({.flight = gains_more}), "velocity differs");
  void (*const impacts[])(std::optional<Impact>&) = {
      [](std::optional<Impact>& impact) { impact.value().t_s *= 1.001; },
      [](std::optional<Impact>& impact) { impact.value().t_s = kNaN; },
      [](std::optional<Impact>& impact) { impact.reset(); },
      [](std::optional<Impact>& impact) { impact.value().speed_px_per_s *= 1.001; }};
  for (const auto& impact : impacts) EXPECT_EQ(fault_of({.impact = impact}), "time of impact differs");
  EXPECT_EQ(fault_of({.model_rate_hz = 60.6}), "model error differs");
  EXPECT_EQ(fault_of({.height_sign = -1.0}), "energy differs");
  EXPECT_EQ(fault_of({.gain_height_sign = -1.0}), "energy differs");
}

// As after minutes of suspend: between the last row and the ground it rises up to 1e7 px.
TEST(ReferenceCheck, MeasuresALongClampedFrameByTheWayFlownInIt) {
  for (int number = 0; number < 60; ++number) {
    Closed closed{.thrown_px_per_s = -2.5e5 - 997.0 * number, .clamped_dt_s = 600.0};
    EXPECT_EQ(fault_of(closed), "") << closed.thrown_px_per_s << " px/s";
    closed.impact = [](std::optional<Impact>& impact) { impact.value().t_s *= 1.0 + 1e-11; };
    EXPECT_EQ(fault_of(closed), "time of impact differs") << closed.thrown_px_per_s << " px/s";
    closed.impact = [](std::optional<Impact>& impact) { impact.value().t_s = HUGE_VAL; };
    EXPECT_EQ(fault_of(closed), "time of impact differs") << closed.thrown_px_per_s << " px/s";
  }
}

}  // namespace
}  // namespace hyrax
