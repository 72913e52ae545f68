// Contacts of a core whose step is not the paper's.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sim/core/kernel.h"
#include "sim/motion/state.h"
#include "sim/trace/step_player.h"

namespace hyrax {

/// Which walls a step met, as its two rows show it: for a core that has no listing to tell.
///
/// A step met a wall if its position is on or past the wall's bound, or if its velocity turned from towards
/// the wall to away from it within reach: the bound is no farther from the position before the step than the
/// faster of both velocities goes in dt. The reach tells a bounce from the apex of a flight. At most one wall
/// of each direction; left before right and top before ground, as in the listing.
class RowWalls {
 public:
  explicit RowWalls(const Bounds& bounds) : bounds_(bounds) {}

  /// A row's contact byte: the walls met, and the rest bit where the ground was and vy is 0.
  /// @param before the state after the inputs of the frame.
  [[nodiscard]] std::uint8_t contact_of(const State& before, double dt_s, const State& after) const {
    const std::uint8_t in_x = met({before.x_px, before.vx_px_per_s}, dt_s, {after.x_px, after.vx_px_per_s},
                                  bounds_.right_px, Wall::left, Wall::right);
    const std::uint8_t in_y = met({before.y_px, before.vy_px_per_s}, dt_s, {after.y_px, after.vy_px_per_s},
                                  bounds_.bottom_px, Wall::top, Wall::ground);
    const bool rests = touches(in_y, Wall::ground) && after.vy_px_per_s == 0.0;
    return static_cast<std::uint8_t>(in_x | in_y | (rests ? kRestBit : 0));
  }

 private:
  struct Motion {
    double at_px;
    double v_px_per_s;
  };

  // Of the walls at 0 and at `high_px`.
  static std::uint8_t met(const Motion& before, double dt_s, const Motion& after, double high_px, Wall low,
                          Wall high) {
    const double reach_px = std::max(std::fabs(before.v_px_per_s), std::fabs(after.v_px_per_s)) * dt_s;
    const bool turned_up = before.v_px_per_s < 0.0 && after.v_px_per_s > 0.0;
    const bool turned_down = before.v_px_per_s > 0.0 && after.v_px_per_s < 0.0;
    if (after.at_px <= 0.0 || (turned_up && before.at_px <= reach_px)) return static_cast<std::uint8_t>(low);
    if (after.at_px >= high_px || (turned_down && high_px - before.at_px <= reach_px))
      return static_cast<std::uint8_t>(high);
    return 0;
  }

  Bounds bounds_;
};

/// Members of a step that a row shows: x, y, vx, vy.
inline constexpr std::size_t kMembersOfRows = 4;

/// Plays the rows of another kernel, and tells their contacts. With the core's traced step, that is played
/// once beside each step, from the same state: the walls are those beyond which its comparisons found the
/// position (sim/trace/step_walls.h). Without one the rows tell them: a step whose row is what the paper's
/// step with the core's constants makes of the row before has that one's contacts; of any other see
/// RowWalls, and `before` is the velocity before the step, `overshoot` NaN.
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
