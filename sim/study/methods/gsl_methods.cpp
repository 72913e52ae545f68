#include <fmt/format.h>

#include "sim/reference/gsl_driver.h"
#include "sim/study/methods/method.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

// Flies without walls, inside a frame in steps of its own.
class GslMethod final : public Method {
 public:
  GslMethod(const Core& core, const GslOptions& options)
      : laws_(reference_model(core)), driver_(options, 2) {}

  void start(const State& motion, const Bounds&, bool) override {
    start_ = motion;
    driver_.start(0, {0.0, motion.vx_px_per_s}, 0.0);
    driver_.start(1, {0.0, motion.vy_px_per_s}, laws_.gravity_px_per_s2);
  }
  [[nodiscard]] bool play(std::span<const double> frames_s) override {
    for (const double frame_s : frames_s)
      if (!driver_.advance(frame_s, laws_.drag_rate_per_s * frame_s)) return false;
    return true;
  }
  [[nodiscard]] State motion() const override {
    const AxisMotion x = driver_.at(0), y = driver_.at(1);
    return {start_.x_px + x.displacement_px, start_.y_px + y.displacement_px, x.speed_px_per_s,
            y.speed_px_per_s};
  }

 private:
  FixedLaws laws_;
  GslDriver driver_;
  State start_;
};

}  // namespace

std::vector<MethodKind> gsl_methods(const Core& core, bool is_quick) {
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
                         .make = [&core, options] { return std::make_unique<GslMethod>(core, options); }});
    }
  return methods;
}

}  // namespace hyrax
