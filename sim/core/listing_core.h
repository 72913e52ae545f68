// The paper's step with any constants, as a core that a replay can play.
#pragma once

#include <optional>
#include <vector>

#include "sim/core/core.h"
#include "sim/motion/state.h"

namespace hyrax {

/// A core whose step is a value: what a replay plays in place of class physics.
/// Has the interface of class physics that a stepper asks for (sim/core/stepper_of.h).
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

/// Makes cores of a step, for a stepper (sim/core/stepper_of.h).
template <class Step>
struct StepCores {
  using Core = StepCore<Step>;
  Step step = {};
  [[nodiscard]] Core make(const State& state) const { return {step, state}; }
};

/// Plays the step of sim/motion/step.h, all parts in the paper's order. With the constants of class physics
/// it gives the bits of the shipped core, slower. A golden file's rows are restored with its own constants,
/// whatever a program's core does.
[[nodiscard]] Core listing_core(const Constants& constants);

/// What plays a scenario of these parameters: the paper's step with the core's own constants and these; the
/// core itself where there are none, or where it was made with them. Nothing: the core's step is not the
/// paper's, or has no constant of such a name.
[[nodiscard]] std::optional<Core> with_parameters(const Core& core, const std::vector<Parameter>& parameters);

}  // namespace hyrax
