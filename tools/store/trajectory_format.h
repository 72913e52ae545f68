// The format `hyrax-trajectory/1`, as golden/README.md describes it: what reader and writers share.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "sim/motion/state.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

inline constexpr std::string_view kTrajectoryFormat = "hyrax-trajectory/1";

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

/// Calls visit(name, member) for each number of a keyframe's time, a dataset of /blocks each. @param timeline
/// may be const.
void visit_timeline(auto& timeline, const auto& visit) {
  visit("time_base", timeline.base_s);
  visit("time_comp", timeline.comp_s);
  visit("time_dt", timeline.dt_s);
  visit("time_frames", timeline.frames);
}

/// The same of a keyframe, for each number besides its row: what a replay from a block needs.
void visit_numbers(auto& keyframe, const auto& visit) {
  visit_timeline(keyframe.timeline, visit);
  visit("window_width", keyframe.window.width_px);
  visit("window_height", keyframe.window.height_px);
  visit("sprite_width", keyframe.sprite.width_px);
  visit("sprite_height", keyframe.sprite.height_px);
  visit("is_held", keyframe.is_held);
}

/// Names of the kinds, by code.
[[nodiscard]] std::span<const std::string_view> input_kind_names();

/// `a` and `b`: a velocity, a position, a size, or a dt; 0 where the kind has no number.
struct InputRecord {
  std::int64_t frame = 0;
  std::uint8_t kind = 0;
  double a = 0.0;
  double b = 0.0;
};

/// REQUIRES: a resize is of the window or of the sprite.
[[nodiscard]] InputRecord record_of(const Input& input);
/// Nothing where no input has this record.
[[nodiscard]] std::optional<Input> input_of(const InputRecord& record);

}  // namespace hyrax
