// One of GSL's drivers on a flight with linear drag.
#pragma once

#include <gsl/gsl_odeiv2.h>

#include <array>
#include <cstddef>
#include <memory>

#include "sim/reference/double_double.h"
#include "sim/reference/flight.h"
#include "sim/reference/gsl_flight.h"

namespace hyrax {

/// Flies along one or two axes, frame by frame; allocates once.
class GslDriver {
 public:
  static constexpr std::size_t kAxesMax = 2;
  /// So many equal frames are solved in one piece; then the driver restarts from the sum.
  static constexpr int kFramesPerPiece = 128;

  /// REQUIRES: axes is 1 or 2. ERRORS: std::bad_alloc.
  GslDriver(const GslOptions& options, std::size_t axes);
  GslDriver(const GslDriver&) = delete;
  GslDriver& operator=(const GslDriver&) = delete;

  /// Begins a flight along `axis`; to be called for each one.
  void start(std::size_t axis, const AxisMotion& from, double acceleration_px_per_s2);
  /// Flies one frame on, in which drag takes the part 1 - exp(-drag) of the speed.
  /// Returns false where GSL failed or a value in or out is not finite.
  [[nodiscard]] bool advance(double frame_s, double drag);
  [[nodiscard]] AxisMotion at(std::size_t axis) const;

 private:
  // GSL solves for the changes p and u since the restart. Time is counted in frames, since the drag of
  // a frame is the same however short it is: by the second its rate would go beyond the largest double
  // where a frame is subnormal.
  //   dp/dn = h v + h u,  du/dn = (a h - c v) - c u,  with h = frame, c = drag, v the speed at the restart
  struct Force {
    std::size_t axes = 0;
    double frame_s = 0.0;
    double drag = 0.0;
    std::array<double, kAxesMax> coast_px{};
    std::array<double, kAxesMax> push_px_per_s{};
  };
  struct Start {
    DoubleDouble position_px;
    DoubleDouble speed_px_per_s;
    double acceleration_px_per_s2 = 0.0;
  };
  struct Free {
    void operator()(gsl_odeiv2_driver* driver) const { gsl_odeiv2_driver_free(driver); }
  };

  // The number of axes is fixed here, since this is most of what GSL does.
  template <std::size_t axes>
  static int derivatives(double time, const double state[], double rates[], void* force);
  static int jacobian(double time, const double state[], double by_state[], double by_time[], void* force);
  void restart(double frame_s, double drag);
  [[nodiscard]] bool takes_whole_frame();
  [[nodiscard]] bool is_sound() const;

  double tolerance_;
  bool is_rk8pd_;
  bool tries_whole_frames_ = false;  // Until one is not accurate enough.
  Force force_;
  gsl_odeiv2_system system_;
  std::unique_ptr<gsl_odeiv2_driver, Free> driver_;
  std::array<Start, kAxesMax> starts_;
  std::array<double, 2 * kAxesMax> state_{};  // p and u of each axis.
  // Time goes on until the next restart, since the multistep methods take a step that begins at the time
  // of the last one for its repetition.
  double time_frames_ = 0.0;
  int frames_ = 0;
};

}  // namespace hyrax
