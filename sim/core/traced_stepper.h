// Traced steps that are played beside the rows of a core.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/core/core.h"
#include "sim/core/stepper.h"
#include "sim/motion/state.h"
#include "sim/trace/step_player.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// Members of a step that a row shows: x, y, vx, vy.
inline constexpr std::size_t kMembersOfRows = 4;

/// Plays the rows of another stepper, with a body of each traced step beside them. All bodies get the same
/// inputs and have the row's x, y, vx and vy; further members are each one's own, and go on in
/// CoreBody::object behind the object of the core.
class TracedStepper : public StepperOver {
 public:
  /// @param steps null ones are left out.
  TracedStepper(std::shared_ptr<const Stepper> rows, std::vector<std::shared_ptr<const StepProgram>> steps)
      : StepperOver(std::move(rows)), steps_(std::move(steps)) {
    std::erase(steps_, nullptr);
  }

  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const final;
  void apply(const Action& action, Keyframe& now) const final;

 private:
  /// Of log.frames rows that were played from `from`, not held: moves the bodies through them.
  virtual void tell(const Stretch& stretch, const State& from, std::span<TracedBody> bodies,
                    std::size_t first_row, RowBlock& rows, StretchLog& log) const = 0;

  [[nodiscard]] std::vector<TracedBody> take_bodies(CoreBody& body) const;
  static void keep_bodies(std::vector<TracedBody>& bodies, const State& row, std::vector<std::byte>& object);

  std::vector<std::shared_ptr<const StepProgram>> steps_;
};

/// Nothing if the step is not playable. REQUIRES: a step as canonical() or read_step() return it.
[[nodiscard]] std::optional<Core> traced_core(const TracedStep& step);

}  // namespace hyrax
