// A core whose step is a value: what a replay plays in place of class physics.
#pragma once

#include "sim/motion/state.h"

namespace hyrax {

/// Has the interface of class physics that a kernel asks for (sim/core/kernel_of.h).
/// @tparam Step copied with each core: `step(State&, double dt_s, const Bounds&)`.
template <class Step>
class StepCore : World {
 public:
  StepCore(const Step& step, const State& start) : step_(step) { state = start; }

  void update(double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
              int sprite_height_px) {
    step_(state, dt_s, bounds_of({window_width_px, window_height_px}, {sprite_width_px, sprite_height_px}));
  }
  [[nodiscard]] double x() const { return state.x_px; }
  [[nodiscard]] double y() const { return state.y_px; }
  [[nodiscard]] double vx() const { return state.vx_px_per_s; }
  [[nodiscard]] double vy() const { return state.vy_px_per_s; }
  using World::resetVelocity;
  using World::setPos;
  using World::setVelocity;

 private:
  Step step_;
};

}  // namespace hyrax
