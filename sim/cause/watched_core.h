// A core whose steps are watched while a replay plays them.
#pragma once

#include <functional>

#include "sim/core/core.h"
#include "sim/core/traced_stepper.h"

namespace hyrax {

/// Passes on every step that is computed: a replay skips those that repeat.
class WatchedStepper final : public TracedStepper {
 public:
  /// @param bodies of the traced steps, before the step; they are left as it makes them.
  using OnStep = std::function<void(const StepInput&, std::span<TracedBody> bodies)>;

  WatchedStepper(std::shared_ptr<const Stepper> stepper,
                 std::vector<std::shared_ptr<const StepProgram>> steps, OnStep on_step)
      : TracedStepper(std::move(stepper), std::move(steps)), on_step_(std::move(on_step)) {}

 private:
  void tell(const Stretch& stretch, const State& from, std::span<TracedBody> bodies, std::size_t first_row,
            RowBlock& rows, StretchLog&) const override {
    StepInput step{{from, stretch.window, stretch.sprite, stretch.is_held}, 0.0};
    for (std::size_t row = first_row; row < rows.size(); ++row) {
      const Row after = rows.row(row);
      step.dt_s = after.dt_s;
      for (TracedBody& body : bodies) body.set_row(step.world.state);
      on_step_(step, bodies);
      step.world.state = state_of(after);
    }
  }

  OnStep on_step_;
};

/// The core, each step of its replays passed on, with bodies of the traced steps.
[[nodiscard]] inline Core watched(Core core, std::vector<std::shared_ptr<const StepProgram>> steps,
                                  WatchedStepper::OnStep on_step) {
  core.stepper =
      std::make_shared<const WatchedStepper>(std::move(core.stepper), std::move(steps), std::move(on_step));
  return core;
}

}  // namespace hyrax
