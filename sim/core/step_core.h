// A core whose step is a value: what a replay plays in place of class physics.
#pragma once

#include "sim/motion/state.h"

namespace hyrax {

/// Has the interface of class physics that a kernel asks for (sim/core/kernel_of.h).
/// @tparam Step copied with each core: `step(State&, double dt_s, const Bounds&)`.
template <class Step>
class StepCore {
 public:
  StepCore(const Step& step, const State& state) : step_(step), state_(state) {}

  void update(double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
              int sprite_height_px) {
    step_(state_, dt_s, bounds_of({window_width_px, window_height_px}, {sprite_width_px, sprite_height_px}));
  }
  [[nodiscard]] double x() const { return state_.x_px; }
  [[nodiscard]] double y() const { return state_.y_px; }
  [[nodiscard]] double vx() const { return state_.vx_px_per_s; }
  [[nodiscard]] double vy() const { return state_.vy_px_per_s; }
  void setPos(double x_px, double y_px) {
    state_.x_px = x_px;
    state_.y_px = y_px;
  }
  void setVelocity(double vx_px_per_s, double vy_px_per_s) {
    state_.vx_px_per_s = vx_px_per_s;
    state_.vy_px_per_s = vy_px_per_s;
  }
  void resetVelocity() { setVelocity(0.0, 0.0); }

 private:
  Step step_;
  State state_;
};

}  // namespace hyrax
