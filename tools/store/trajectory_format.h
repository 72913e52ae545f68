// The format `hyrax-trajectory/1`, as golden/README.md describes it: what reader and writers share.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "sim/motion/state.h"
#include "sim/trajectory/columns.h"

namespace hyrax {

inline constexpr std::string_view kTrajectoryFormat = "hyrax-trajectory/1";

/// The attributes of `/`.
struct FileHead {
  Scenario scenario;
  std::int64_t steps = 0;
  std::string physics;
  std::string state_hash;  ///< 32 hex digits.
  /// Of the core that played the run: the paper's where the file of a paper's model does not have them,
  /// nothing for a core of one's own.
  std::optional<Constants> constants;
  std::string core = {};           ///< CoreRecord::checksum of that core; empty: the file does not say.
  std::uint8_t walls_of_rows = 0;  ///< As StoredRun's; attributes of /contacts.
};

/// The numbers of the attribute `constants`, in the order of the paper's table.
using ConstantNumbers = std::array<double, 5>;
[[nodiscard]] constexpr ConstantNumbers numbers_of(const Constants& constants) {
  return {constants.gravity_px_per_s2, constants.restitution, constants.air_drag, constants.ground_friction,
          constants.rest_threshold_px_per_s};
}
[[nodiscard]] constexpr Constants constants_of(const ConstantNumbers& numbers) {
  return {.gravity_px_per_s2 = numbers[0],
          .restitution = numbers[1],
          .air_drag = numbers[2],
          .ground_friction = numbers[3],
          .rest_threshold_px_per_s = numbers[4]};
}

/// Calls visit(name, member) for each number of a keyframe besides its row: what a replay from a block needs,
/// a dataset of /blocks each. @param keyframe may be const.
void visit_numbers(auto& keyframe, const auto& visit) {
  visit("time_base", keyframe.timeline.base_s);
  visit("time_comp", keyframe.timeline.comp_s);
  visit("time_dt", keyframe.timeline.dt_s);
  visit("time_frames", keyframe.timeline.frames);
  visit("window_width", keyframe.window.width_px);
  visit("window_height", keyframe.window.height_px);
  visit("sprite_width", keyframe.sprite.width_px);
  visit("sprite_height", keyframe.sprite.height_px);
  visit("is_held", keyframe.is_held);
}

}  // namespace hyrax
