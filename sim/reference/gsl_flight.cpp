#include "sim/reference/gsl_flight.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>

namespace hyrax {
namespace {

// The unknowns in GSL's order; without horizontal motion the first two are all.
enum Unknown : std::size_t { kDy, kVy, kDx, kVx, kUnknowns };
constexpr std::size_t kUnknownsInY = 2;

struct Force {
  double gravity_px_per_s2 = 0.0;
  double drag_rate_per_s = 0.0;
  std::size_t unknowns = kUnknowns;
};

// GSL's explicit steppers take a NaN for a success, so it is refused here.
int derivatives(double, const double state[], double rates[], void* parameters) {
  const Force& force = *static_cast<const Force*>(parameters);
  rates[kDy] = state[kVy];
  rates[kVy] = force.gravity_px_per_s2 - force.drag_rate_per_s * state[kVy];
  double sum = rates[kDy] + rates[kVy];
  if (force.unknowns == kUnknowns) {
    rates[kDx] = state[kVx];
    rates[kVx] = -force.drag_rate_per_s * state[kVx];
    sum += rates[kDx] + rates[kVx];
  }
  return std::isfinite(sum) ? GSL_SUCCESS : GSL_EBADFUNC;
}

int jacobian(double, const double[], double by_state[], double by_time[], void* parameters) {
  const Force& force = *static_cast<const Force*>(parameters);
  const std::size_t n = force.unknowns;
  std::fill_n(by_state, n * n, 0.0);
  std::fill_n(by_time, n, 0.0);
  for (std::size_t position = 0; position < n; position += 2) {
    by_state[position * n + position + 1] = 1.0;
    by_state[(position + 1) * n + position + 1] = -force.drag_rate_per_s;
  }
  return GSL_SUCCESS;
}

const gsl_odeiv2_step_type* type_of(GslStepper stepper) {
  switch (stepper) {
    case GslStepper::rk2:
      return gsl_odeiv2_step_rk2;
    case GslStepper::rk4:
      return gsl_odeiv2_step_rk4;
    case GslStepper::rkf45:
      return gsl_odeiv2_step_rkf45;
    case GslStepper::rkck:
      return gsl_odeiv2_step_rkck;
    case GslStepper::rk8pd:
      return gsl_odeiv2_step_rk8pd;
    case GslStepper::rk1imp:
      return gsl_odeiv2_step_rk1imp;
    case GslStepper::rk2imp:
      return gsl_odeiv2_step_rk2imp;
    case GslStepper::rk4imp:
      return gsl_odeiv2_step_rk4imp;
    case GslStepper::bsimp:
      return gsl_odeiv2_step_bsimp;
    case GslStepper::msadams:
      return gsl_odeiv2_step_msadams;
    case GslStepper::msbdf:
      return gsl_odeiv2_step_msbdf;
  }
  return gsl_odeiv2_step_rk8pd;
}

struct FreeDriver {
  void operator()(gsl_odeiv2_driver* driver) const { gsl_odeiv2_driver_free(driver); }
};

// One driver, allocated once, for 2 or 4 unknowns.
class Driver {
 public:
  Driver(const GslOptions& options, double gravity_px_per_s2, std::size_t unknowns)
      : force_{gravity_px_per_s2, 0.0, unknowns}, system_{derivatives, jacobian, unknowns, &force_} {
    constexpr double kAnyFirstStep_s = 1e-3;  // Each restart sets its own.
    driver_.reset(gsl_odeiv2_driver_alloc_y_new(&system_, type_of(options.stepper), kAnyFirstStep_s,
                                                options.tolerance, options.tolerance));
    if (!driver_) throw std::bad_alloc();
    gsl_odeiv2_driver_set_nmax(driver_.get(), kGslStepsPerFrameMax);
  }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  void restart(double drag_rate_per_s, double frame_s) {
    force_.drag_rate_per_s = drag_rate_per_s;
    frame_s_ = frame_s;
    frames_ = 0.0;
    t_s_ = 0.0;
    gsl_odeiv2_driver_reset_hstart(driver_.get(), frame_s);
  }
  // One frame on. Time goes on from the restart, since the multistep methods take a step that begins
  // at the time of the last one for its repetition; it is a product, which does not drift.
  bool advance(double* state) {
    frames_ += 1.0;
    return gsl_odeiv2_driver_apply(driver_.get(), &t_s_, frames_ * frame_s_, state) == GSL_SUCCESS;
  }

 private:
  Force force_;
  gsl_odeiv2_system system_;
  std::unique_ptr<gsl_odeiv2_driver, FreeDriver> driver_;
  double frame_s_ = 0.0;
  double frames_ = 0.0;  // Since the restart.
  double t_s_ = 0.0;
};

}  // namespace

struct GslFlight::Solver {
  Solver(const GslOptions& chosen, const Model& model)
      : options(chosen),
        air_drag(model.air_drag),
        log_air_drag(std::log(model.air_drag)),
        in_y(chosen, model.gravity_px_per_s2, kUnknownsInY),
        in_both(chosen, model.gravity_px_per_s2, kUnknowns) {}

  bool is_sound() const {
    return std::all_of(state, state + kUnknowns, [](double value) { return std::isfinite(value); });
  }

  bool advance(double dt_s) {
    if (!(dt_s >= 0.0) || !std::isfinite(dt_s))
      return false;  // GSL does nothing to t1 = NaN, and is content.
    if (dt_s == 0.0) {
      state[kVy] *= air_drag;
      state[kVx] *= air_drag;
      rate_dt_s = 0.0;
      return true;
    }
    Driver& driver = solves_x ? in_both : in_y;
    if (dt_s != rate_dt_s) driver.restart(-log_air_drag / dt_s, dt_s);
    rate_dt_s = dt_s;
    return driver.advance(state);
  }

  GslOptions options;
  double air_drag;
  double log_air_drag;
  Driver in_y;
  Driver in_both;
  bool solves_x = true;
  bool has_failed = false;
  double rate_dt_s = 0.0;  // Of the frames since the last restart.
  double state[kUnknowns] = {};
};

GslFlight::GslFlight(const GslOptions& options, const Model& model) {
  assert(options.tolerance >= kGslToleranceMin && options.tolerance <= kGslToleranceMax);
  gsl_set_error_handler_off();
  solver_ = std::make_unique<Solver>(options, model);
}

GslFlight::~GslFlight() = default;

void GslFlight::start(const Velocity& velocity, bool solves_x) {
  Solver& solver = *solver_;
  solver.solves_x = solves_x;
  solver.rate_dt_s = 0.0;
  solver.state[kDy] = solver.state[kDx] = 0.0;
  solver.state[kVy] = velocity.vy_px_per_s;
  solver.state[kVx] = solves_x ? velocity.vx_px_per_s : 0.0;
  solver.has_failed = !solver.is_sound();
}

bool GslFlight::advance(double dt_s) {
  Solver& solver = *solver_;
  if (!solver.has_failed) solver.has_failed = !solver.advance(dt_s) || !solver.is_sound();
  return !solver.has_failed;
}

Flight GslFlight::flight() const {
  const double* state = solver_->state;
  return {state[kDx], state[kDy], state[kVx], state[kVy]};
}

bool GslFlight::is_judge() const {
  return solver_->options.stepper == GslStepper::rk8pd && solver_->options.tolerance <= 1e-12;
}

}  // namespace hyrax
