// A core whose steps are watched while a replay plays them.
#pragma once

#include <functional>

#include "sim/core/core.h"
#include "sim/trace/step_player.h"

namespace hyrax {

/// Passes on every step that is computed: a replay skips those that repeat.
class WatchedKernel final : public KernelOver {
 public:
  using OnStep = std::function<void(const StepInput&)>;

  WatchedKernel(std::shared_ptr<const Kernel> kernel, OnStep on_step)
      : KernelOver(std::move(kernel)), on_step_(std::move(on_step)) {}

  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const override {
    StepInput step{{body.state, stretch.window, stretch.sprite, stretch.is_held}, 0.0};
    std::size_t row = rows.size();
    KernelOver::play(stretch, body, rest, rows, log);
    if (stretch.is_held) return;
    for (; row < rows.size(); ++row) {
      const Row after = rows.row(row);
      step.dt_s = after.dt_s;
      on_step_(step);
      step.world.state = state_of(after);
    }
  }

 private:
  OnStep on_step_;
};

/// The core, each step of its replays passed on.
[[nodiscard]] inline Core watched(Core core, WatchedKernel::OnStep on_step) {
  core.kernel = std::make_shared<const WatchedKernel>(std::move(core.kernel), std::move(on_step));
  return core;
}

}  // namespace hyrax
