#include "sim/reference/gsl_driver.h"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace hyrax {
namespace {

constexpr double kFirstStep_frames = 1.0;

// By GslStepper.
const gsl_odeiv2_step_type* type_of(GslStepper stepper) {
  const std::array types = {gsl_odeiv2_step_rk2,     gsl_odeiv2_step_rk4,    gsl_odeiv2_step_rkf45,
                            gsl_odeiv2_step_rkck,    gsl_odeiv2_step_rk8pd,  gsl_odeiv2_step_rk1imp,
                            gsl_odeiv2_step_rk2imp,  gsl_odeiv2_step_rk4imp, gsl_odeiv2_step_bsimp,
                            gsl_odeiv2_step_msadams, gsl_odeiv2_step_msbdf};
  static_assert(types.size() == kGslStepperNames.size());
  return types[static_cast<std::size_t>(stepper)];
}

}  // namespace

GslDriver::GslDriver(const GslOptions& options, std::size_t axes)
    : tolerance_(options.tolerance),
      is_rk8pd_(options.stepper == GslStepper::rk8pd),
      force_{.axes = axes},
      system_{axes == 1 ? derivatives<1> : derivatives<2>, jacobian, 2 * axes, &force_} {
  driver_.reset(gsl_odeiv2_driver_alloc_y_new(&system_, type_of(options.stepper), kFirstStep_frames,
                                              options.tolerance, options.tolerance));
  if (!driver_) throw std::bad_alloc();
  gsl_odeiv2_driver_set_nmax(driver_.get(), kGslStepsPerFrameMax);
}

void GslDriver::start(std::size_t axis, const AxisMotion& from, double acceleration_px_per_s2) {
  starts_[axis] = {{from.displacement_px, 0.0}, {from.speed_px_per_s, 0.0}, acceleration_px_per_s2};
  state_[2 * axis] = state_[2 * axis + 1] = 0.0;
  frames_ = kFramesPerPiece;
}

bool GslDriver::advance(double frame_s, double drag) {
  // GSL does nothing to t1 = NaN, and reports success.
  if (!(frame_s >= 0.0) || !std::isfinite(frame_s)) return false;
  if (frames_ == kFramesPerPiece || frame_s != force_.frame_s || drag != force_.drag) restart(frame_s, drag);
  ++frames_;
  if (!takes_whole_frame() &&
      gsl_odeiv2_driver_apply(driver_.get(), &time_frames_, frames_, state_.data()) != GSL_SUCCESS)
    return false;
  return is_sound();
}

// The driver's own first step, and its judgement, without what it does to choose the length of the next one.
bool GslDriver::takes_whole_frame() {
  if (!tries_whole_frames_) return false;
  const std::array<double, 2 * kAxesMax> before = state_;
  std::array<double, 2 * kAxesMax> errors{};
  const int status = gsl_odeiv2_step_apply(driver_->s, time_frames_, kFirstStep_frames, state_.data(),
                                           errors.data(), nullptr, nullptr, &system_);
  for (std::size_t index = 0; index < 2 * force_.axes; ++index)
    tries_whole_frames_ = tries_whole_frames_ && status == GSL_SUCCESS &&
                          std::fabs(errors[index]) <= 1.1 * tolerance_ * (1.0 + std::fabs(state_[index]));
  if (tries_whole_frames_)
    time_frames_ += kFirstStep_frames;
  else
    state_ = before;
  return tries_whole_frames_;
}

AxisMotion GslDriver::at(std::size_t axis) const {
  const Start& start = starts_[axis];
  return {start.position_px.hi + (start.position_px.lo + state_[2 * axis]),
          start.speed_px_per_s.hi + (start.speed_px_per_s.lo + state_[2 * axis + 1])};
}

// The push is small where drag and acceleration balance: formed once, with the speed's low part, so that
// a fall at its final speed does not gather the same rounding frame after frame.
void GslDriver::restart(double frame_s, double drag) {
  force_.frame_s = frame_s;
  force_.drag = drag;
  for (std::size_t axis = 0; axis < force_.axes; ++axis) {
    Start& start = starts_[axis];
    start.position_px = start.position_px + state_[2 * axis];
    start.speed_px_per_s = start.speed_px_per_s + state_[2 * axis + 1];
    state_[2 * axis] = state_[2 * axis + 1] = 0.0;
    force_.coast_px[axis] = frame_s * start.speed_px_per_s.hi;
    force_.push_px_per_s[axis] = (start.acceleration_px_per_s2 * frame_s - drag * start.speed_px_per_s.hi) -
                                 drag * start.speed_px_per_s.lo;
  }
  time_frames_ = 0.0;
  frames_ = 0;
  tries_whole_frames_ = is_rk8pd_;
  gsl_odeiv2_driver_reset_hstart(driver_.get(), kFirstStep_frames);
}

bool GslDriver::is_sound() const {
  double sum = 0.0;
  for (const double value : state_) sum += value - value;
  return sum == 0.0;  // Not so where a value is infinite or NaN.
}

// GSL's explicit steppers take a NaN for a success, so it is refused here.
template <std::size_t axes>
int GslDriver::derivatives(double, const double state[], double rates[], void* parameters) {
  const Force& force = *static_cast<const Force*>(parameters);
  double sum = 0.0;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const double speed = state[2 * axis + 1];
    rates[2 * axis] = force.coast_px[axis] + force.frame_s * speed;
    rates[2 * axis + 1] = force.push_px_per_s[axis] - force.drag * speed;
    sum += rates[2 * axis] + rates[2 * axis + 1];
  }
  return std::isfinite(sum) ? GSL_SUCCESS : GSL_EBADFUNC;
}

int GslDriver::jacobian(double, const double[], double by_state[], double by_time[], void* parameters) {
  const Force& force = *static_cast<const Force*>(parameters);
  const std::size_t n = 2 * force.axes;
  std::fill_n(by_state, n * n, 0.0);
  std::fill_n(by_time, n, 0.0);
  for (std::size_t position = 0; position < n; position += 2) {
    by_state[position * n + position + 1] = force.frame_s;
    by_state[(position + 1) * n + position + 1] = -force.drag;
  }
  return GSL_SUCCESS;
}

}  // namespace hyrax
