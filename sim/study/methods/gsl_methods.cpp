#include <cmath>

#include <fmt/format.h>

#include "sim/reference/gsl_flight.h"
#include "sim/study/methods/method.h"
#include "sim/study/methods/method_errors.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

// The matched ODE of frames of 1 / kRowRate_hz is the fixed one, by the drag factor that such frames have.
Model model_of_fixed_laws() {
  Model model = reference_model();
  model.air_drag = std::pow(model.air_drag, model.model_rate_hz / kRowRate_hz);
  return model;
}

// Flies without walls, inside a frame in steps of its own.
class GslMethod final : public Method {
 public:
  explicit GslMethod(const GslOptions& options) : solver_(options, model_of_fixed_laws()) {}

  void start(const State& motion, const Bounds&) override {
    start_ = motion;
    solver_.start({motion.vx_px_per_s, motion.vy_px_per_s}, true);
  }
  [[nodiscard]] bool play(std::span<const double> frames_s) override {
    for (const double frame_s : frames_s)
      if (!solver_.advance(frame_s)) return false;
    return true;
  }
  [[nodiscard]] State motion() const override {
    const Flight flight = solver_.flight();
    return {start_.x_px + flight.dx_px, start_.y_px + flight.dy_px, flight.vx_px_per_s, flight.vy_px_per_s};
  }

 private:
  GslFlight solver_;
  State start_;
};

}  // namespace

std::vector<MethodKind> gsl_methods(bool is_quick) {
  const std::vector<double> tolerances =
      is_quick ? std::vector{1e-4, 1e-8, 1e-12} : std::vector{1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14};
  std::vector<MethodKind> methods;
  for (std::size_t stepper = 0; stepper < kGslStepperNames.size(); ++stepper)
    for (const double tolerance : tolerances) {
      const GslOptions options{static_cast<GslStepper>(stepper), tolerance};
      if (is_quick && options.stepper == GslStepper::rk1imp) continue;
      const std::string_view name = kGslStepperNames[stepper];
      methods.push_back({.name = fmt::format("gsl-{}-{:g}", name, tolerance),
                         .label = fmt::format("GSL {} at {:g}", name, tolerance),
                         .family = fmt::format("GSL {}", name),
                         .accuracy = Adaptive{tolerance},
                         .meets_walls = false,
                         .make = [options] { return std::make_unique<GslMethod>(options); }});
    }
  return methods;
}

}  // namespace hyrax
