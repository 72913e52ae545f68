// Contacts of a core whose step is not the paper's.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sim/core/kernel.h"
#include "sim/trace/step_player.h"

namespace hyrax {

/// Members of a step that a row shows: x, y, vx, vy.
inline constexpr std::size_t kMembersOfRows = 4;

/// Plays the rows of another kernel, and tells their contacts. With the core's traced step, that is played
/// once beside each step, from the same state: the walls are those beyond which its comparisons found the
/// position (sim/trace/step_walls.h). Without one the rows tell them: a step whose row is what the paper's
/// step with the core's constants makes of the row before has that one's contacts; of any other see
/// row_walls.h, and `before` is the velocity before the step, `overshoot` NaN.
class ContactKernel final : public KernelOver {
 public:
  /// @param step null: contacts follow from the rows, with these constants.
  ContactKernel(std::shared_ptr<const Kernel> rows, std::shared_ptr<const StepProgram> step,
                const std::optional<Constants>& constants)
      : KernelOver(std::move(rows)), step_(std::move(step)), constants_(constants) {}

  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const override;
  void apply(const Action& action, Keyframe& now) const override;

 private:
  [[nodiscard]] bool keeps_members() const;
  [[nodiscard]] TracedBody take_traced(CoreBody& body) const;
  void keep_traced(TracedBody& traced, std::vector<std::byte>& object) const;

  std::shared_ptr<const StepProgram> step_;
  std::optional<Constants> constants_;
};

}  // namespace hyrax
