// A core whose steps are watched while a replay plays them.
#pragma once

#include <functional>

#include "sim/replay/kernel.h"
#include "sim/trace/step_player.h"

namespace hyrax {

/// Plays as another kernel does, and passes on every step that is computed: a replay skips those that repeat.
class WatchedKernel final : public Kernel {
 public:
  using OnStep = std::function<void(const StepInput&)>;

  /// Refers to the kernel.
  WatchedKernel(const Kernel& kernel, OnStep on_step) : kernel_(kernel), on_step_(std::move(on_step)) {}

  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const override {
    StepInput step{{body.state, stretch.window, stretch.sprite, stretch.is_held}, 0.0};
    std::size_t row = rows.size();
    kernel_.play(stretch, body, rest, rows, log);
    if (stretch.is_held) return;
    for (; row < rows.size(); ++row) {
      const Row after = rows.row(row);
      step.dt_s = after.dt_s;
      on_step_(step);
      step.world.state = state_of(after);
    }
  }
  [[nodiscard]] std::optional<Constants> constants() const override { return kernel_.constants(); }
  void apply(const Action& action, Keyframe& now) const override { kernel_.apply(action, now); }

 private:
  const Kernel& kernel_;
  OnStep on_step_;
};

}  // namespace hyrax
