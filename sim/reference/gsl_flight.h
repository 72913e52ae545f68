// Flight with linear drag by the GNU Scientific Library.
//
// Other code and other arithmetic than the closed forms, so that the two can check one another.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "sim/reference/flight.h"
#include "sim/reference/model.h"

namespace hyrax {

/// GSL's steppers, by its names.
enum class GslStepper { rk2, rk4, rkf45, rkck, rk8pd, rk1imp, rk2imp, rk4imp, bsimp, msadams, msbdf };

inline constexpr std::array<std::string_view, 11> kGslStepperNames = {
    "rk2", "rk4", "rkf45", "rkck", "rk8pd", "rk1imp", "rk2imp", "rk4imp", "bsimp", "msadams", "msbdf"};

struct GslOptions {
  GslStepper stepper = GslStepper::rk8pd;
  double tolerance = 1e-12;  ///< Of a step, absolute and relative; kGslToleranceMin .. kGslToleranceMax.
  bool operator==(const GslOptions&) const = default;
};

/// Below it the rounding of a step exceeds its tolerance.
inline constexpr double kGslToleranceMin = 1e-14;
inline constexpr double kGslToleranceMax = 1e-1;
/// Steps that a frame may take before the solver counts as failed.
inline constexpr unsigned long kGslStepsPerFrameMax = 10'000;

/// Ends each step on a row. Restarts at every arc, wherever dt changes (a multistep method that
/// remembers other forces is off by hundreds of px), and every 128 frames: GSL sums in plain double,
/// so it solves for the change since the restart, and the sum of the changes is kept to 100 bits.
/// Rounding stays below 1e-14 of the path, however many frames there are.
///
/// The model's flight takes at most 700 steps of rk8pd: once drag has taken all of the first speed, it is a
/// line. A crossing is bracketed between states solved by GSL, and found by Brent's method.
///
/// REQUIRES: options within their limits. Turns GSL's own error handler off, for the whole program.
/// ERRORS: std::bad_alloc.
[[nodiscard]] std::unique_ptr<FlightSolver> gsl_flight(const GslOptions& options = {},
                                                       const Model& model = {});

}  // namespace hyrax
