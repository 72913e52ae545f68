#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <cmath>

#include "sim/core/shipped_core.h"
#include "sim/reference/drift_meter.h"
#include "sim/reference/flight.h"
#include "sim/reference/gsl_flight.h"
#include "sim/replay/replay.h"
#include "sim/scenario/split_mix64.h"
#include "tests/benchmarks/figure.h"
#include "tests/benchmarks/naive_step.h"

namespace hyrax::bench {
namespace {

constexpr int kRounds = 15;
constexpr int kRunsPerRound = 50;
constexpr std::int64_t kSteps = 600;  // 10 s at 60 Hz.

Scenario fling() {
  Scenario scenario;
  scenario.window = {1920, 1080};
  scenario.sprite = {128, 128};
  scenario.start = {60.0, 900.0};
  scenario.start_velocity = {1000.0, -1350.0};
  scenario.clock.base = FixedRate{60.0};
  scenario.length = kSteps;
  return scenario;
}

// Nothing rests, so every row has its errors.
Scenario all_in_flight() {
  Scenario scenario = fling();
  scenario.window = {1'000'000, 1'000'000};
  return scenario;
}

struct EveryRow final : DriftSink {
  [[nodiscard]] bool wants_rows() const override { return true; }
  void row(const RowErrors& row) override { sum += row.truncation_px + row.energy_drift_px2_per_s2; }
  double sum = 0.0;
};

void measure(const Scenario& scenario, FlightSolver* solver) {
  EveryRow rows;
  DriftMeter meter(scenario, {}, rows, solver);
  static_cast<void>(replay(shipped_core(), scenario, meter));
  keep(meter.finish().arcs);
  keep(rows.sum);
}

// Random falls onto a wall that they reach.
std::vector<Approach> approaches() {
  std::vector<Approach> some;
  const auto draw = [](std::uint64_t index, double low, double high) {
    return low + (high - low) * split_mix64_unit(2026, index);
  };
  for (std::uint64_t index = 0; index < 200; ++index)
    some.push_back({-draw(2 * index, 10.0, 900.0), draw(2 * index + 1, -1000.0, 1500.0), 1200.0, 0.0600300});
  return some;
}

constexpr double kLongest_s = 4.0;

// The solution with GSL alone: the flight by rk8pd, solved again at every iteration of Brent's method.
class GslImpact {
 public:
  GslImpact() {
    gsl_set_error_handler_off();
    driver_ = gsl_odeiv2_driver_alloc_y_new(&system_, gsl_odeiv2_step_rk8pd, 1e-2, 1e-12, 1e-12);
    solver_ = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
  }
  GslImpact(const GslImpact&) = delete;
  GslImpact& operator=(const GslImpact&) = delete;
  ~GslImpact() {
    gsl_root_fsolver_free(solver_);
    gsl_odeiv2_driver_free(driver_);
  }

  double time_s(const Approach& approach) {
    approach_ = &approach;
    gsl_function function{
        [](double t_s, void* self) { return static_cast<GslImpact*>(self)->position_px(t_s); }, this};
    // Goes out once, after it has turned towards the wall.
    const double turns_s = std::max(0.0, -approach.speed_px_per_s / approach.acceleration_px_per_s2);
    gsl_root_fsolver_set(solver_, &function, turns_s, kLongest_s);
    constexpr int kGuessesMax = 100;
    for (int guess = 0; guess < kGuessesMax; ++guess) {
      gsl_root_fsolver_iterate(solver_);
      if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver_), gsl_root_fsolver_x_upper(solver_), 0.0,
                                 1e-12) == GSL_SUCCESS)
        break;
    }
    return gsl_root_fsolver_root(solver_);
  }

 private:
  double position_px(double t_s) {
    double state[2] = {approach_->position_px, approach_->speed_px_per_s};
    double t = 0.0;
    gsl_odeiv2_driver_reset(driver_);
    gsl_odeiv2_driver_apply(driver_, &t, t_s, state);
    return state[0];
  }
  static int derivatives(double, const double state[], double rates[], void* self) {
    const Approach& approach = *static_cast<GslImpact*>(self)->approach_;
    rates[0] = state[1];
    rates[1] = approach.acceleration_px_per_s2 - approach.drag_rate_per_s * state[1];
    return GSL_SUCCESS;
  }

  const Approach* approach_ = nullptr;
  gsl_odeiv2_system system_{derivatives, nullptr, 2, this};
  gsl_odeiv2_driver* driver_ = nullptr;
  gsl_root_fsolver* solver_ = nullptr;
};

void drift_ratios(const std::string& what, const Scenario& scenario, std::vector<Figure>& figures) {
  GslFlight gsl;
  const auto repeat = [](const auto& work) {
    return [work] {
      for (int run = 0; run < kRunsPerRound; ++run) work();
    };
  };
  const auto timings = time_side_by_side(
      {repeat([&] { step_naively(start_state(scenario), kSteps, scenario.window); }),
       repeat([&] { measure(scenario, nullptr); }), repeat([&] { measure(scenario, &gsl); })},
      kRounds);
  figures.push_back(ratio("drift of " + what + ", closed form, every row, times naive", timings[1],
                          timings[0], Goal::at_most, 15.0));
  figures.push_back(ratio("drift of " + what + ", GSL beside it, times naive", timings[2], timings[0],
                          Goal::at_most, 60.0));
}

void impact_ratio(std::vector<Figure>& figures) {
  const std::vector<Approach> falls = approaches();
  GslImpact gsl;
  double apart_rel = 0.0;
  for (const Approach& fall : falls) {
    const double closed_s = time_of_impact(fall, kLongest_s).value_or(Impact{}).t_s;
    apart_rel = std::max(apart_rel, std::fabs(closed_s - gsl.time_s(fall)) / closed_s);
  }
  const auto timings = time_side_by_side({[&] {
                                            for (const Approach& fall : falls) keep(gsl.time_s(fall));
                                          },
                                          [&] {
                                            for (const Approach& fall : falls)
                                              keep(time_of_impact(fall, kLongest_s)->t_s);
                                          }},
                                         kRounds);
  figures.push_back(ratio("time of impact, times faster than GSL rk8pd + Brent", timings[0], timings[1],
                          Goal::at_least, 1.0));
  figures.push_back(
      {"(their largest difference, relative)", apart_rel, apart_rel, apart_rel, 1e-12, false, ""});
}

}  // namespace

std::vector<Figure> drift_figures() {
  std::vector<Figure> figures;
  drift_ratios("10 s", fling(), figures);
  drift_ratios("10 s all in flight", all_in_flight(), figures);
  impact_ratio(figures);
  return figures;
}

}  // namespace hyrax::bench
