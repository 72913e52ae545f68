#include "sim/study/methods/solver_method.h"

#include <cmath>

#include "sim/study/methods/method_errors.h"

namespace hyrax {
namespace {

class SolverMethod final : public Method {
 public:
  explicit SolverMethod(std::unique_ptr<FlightSolver> solver) : solver_(std::move(solver)) {}

  void start(const State& motion, const Bounds&) override {
    start_ = motion;
    solver_->start({motion.vx_px_per_s, motion.vy_px_per_s}, true);
  }
  [[nodiscard]] bool play(std::span<const double> frames_s) override {
    for (const double frame_s : frames_s)
      if (!solver_->advance(frame_s)) return false;
    return true;
  }
  [[nodiscard]] State motion() const override {
    const Flight flight = solver_->flight();
    return {start_.x_px + flight.dx_px, start_.y_px + flight.dy_px, flight.vx_px_per_s, flight.vy_px_per_s};
  }

 private:
  std::unique_ptr<FlightSolver> solver_;
  State start_;
};

}  // namespace

std::unique_ptr<Method> method_of(const SolverMaker& make_solver) {
  Model model;
  model.air_drag = std::pow(model.air_drag, model.model_rate_hz / kCheckRate_hz);
  return std::make_unique<SolverMethod>(make_solver(model));
}

}  // namespace hyrax
