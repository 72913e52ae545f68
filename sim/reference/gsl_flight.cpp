#include "sim/reference/gsl_flight.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>
#include <optional>

namespace hyrax {
namespace {

// The unknowns in GSL's order; without horizontal motion the first two are all.
enum Unknown : std::size_t { kDy, kVy, kDx, kVx, kUnknowns };
constexpr std::size_t kUnknownsInY = 2;

// Time is counted in frames, since the drag of a frame is the same however short it is: by the second
// its rate would go beyond the largest double where a frame is subnormal.
//   dy/dn = v h,  dv/dn = G h - c v,  with h = dt and c = -ln(alpha)
struct Force {
  double gravity_px_per_s2 = 0.0;
  double drag_per_frame = 0.0;
  double frame_s = 0.0;
  std::size_t unknowns = kUnknowns;
};

// GSL's explicit steppers take a NaN for a success, so it is refused here.
int derivatives(double, const double state[], double rates[], void* parameters) {
  const Force& force = *static_cast<const Force*>(parameters);
  rates[kDy] = force.frame_s * state[kVy];
  rates[kVy] = force.gravity_px_per_s2 * force.frame_s - force.drag_per_frame * state[kVy];
  double sum = rates[kDy] + rates[kVy];
  if (force.unknowns == kUnknowns) {
    rates[kDx] = force.frame_s * state[kVx];
    rates[kVx] = -force.drag_per_frame * state[kVx];
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
    by_state[position * n + position + 1] = force.frame_s;
    by_state[(position + 1) * n + position + 1] = -force.drag_per_frame;
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
  Driver(const GslOptions& options, const Model& model, std::size_t unknowns)
      : force_{model.gravity_px_per_s2, -std::log(model.air_drag), 0.0, unknowns},
        system_{derivatives, jacobian, unknowns, &force_} {
    driver_.reset(gsl_odeiv2_driver_alloc_y_new(&system_, type_of(options.stepper), kFirstStep_frames,
                                                options.tolerance, options.tolerance));
    if (!driver_) throw std::bad_alloc();
    gsl_odeiv2_driver_set_nmax(driver_.get(), kGslStepsPerFrameMax);
  }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  void restart(double frame_s) {
    force_.frame_s = frame_s;
    time_frames_ = 0.0;
    gsl_odeiv2_driver_reset_hstart(driver_.get(), kFirstStep_frames);
  }
  // One frame on. Time goes on from the restart, since the multistep methods take a step that begins
  // at the time of the last one for its repetition.
  bool advance(double* state) {
    return gsl_odeiv2_driver_apply(driver_.get(), &time_frames_, time_frames_ + 1.0, state) == GSL_SUCCESS;
  }

 private:
  static constexpr double kFirstStep_frames = 1.0;

  Force force_;
  gsl_odeiv2_system system_;
  std::unique_ptr<gsl_odeiv2_driver, FreeDriver> driver_;
  double time_frames_ = 0.0;  // Since the restart: whole after every frame.
};

}  // namespace

struct GslFlight::Solver {
  Solver(const GslOptions& chosen, const Model& model)
      : options(chosen), in_y(chosen, model, kUnknownsInY), in_both(chosen, model, kUnknowns) {}

  bool is_sound() const {
    return std::all_of(state, state + kUnknowns, [](double value) { return std::isfinite(value); });
  }

  bool advance(double dt_s) {
    if (!(dt_s >= 0.0) || !std::isfinite(dt_s))
      return false;  // GSL does nothing to t1 = NaN, and is content.
    Driver& driver = solves_x ? in_both : in_y;
    if (frame_s != dt_s) driver.restart(dt_s);
    frame_s = dt_s;
    return driver.advance(state);
  }

  GslOptions options;
  Driver in_y;
  Driver in_both;
  bool solves_x = true;
  bool has_failed = false;
  std::optional<double> frame_s;  // Of the frames since the last restart.
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
  solver.frame_s.reset();
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
