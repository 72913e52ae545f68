// The state after a frame: what is recorded, and what a replay needs to go on; and runs of consecutive steps
// clamped by the same wall.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/motion/state.h"
#include "sim/scenario/frame_clock.h"

namespace hyrax {

struct Row {
  std::int64_t step = 0;  ///< Row number: frame i makes row i + 1, row 0 is the start.
  double t_s = 0.0;
  double dt_s = 0.0;
  double x_px = 0.0;
  double y_px = 0.0;
  double vx_px_per_s = 0.0;
  double vy_px_per_s = 0.0;
  std::uint8_t contact = 0;  ///< Wall bits and kRestBit.
};

[[nodiscard]] inline State state_of(const Row& row) {
  return {row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s};
}

inline void set_state(Row& row, const State& state) {
  row.x_px = state.x_px;
  row.y_px = state.y_px;
  row.vx_px_per_s = state.vx_px_per_s;
  row.vy_px_per_s = state.vy_px_per_s;
}

[[nodiscard]] inline bool same_bits(const Row& a, const Row& b) {
  return a.step == b.step && same_bits(a.t_s, b.t_s) && same_bits(a.dt_s, b.dt_s) &&
         same_bits(state_of(a), state_of(b)) && a.contact == b.contact;
}

/// The state after a frame: the row, the time as the time rule holds it, the sizes in force and
/// whether the sprite is held. What comes next follows from the scenario and the row's number.
struct Keyframe {
  Row row;
  Timeline timeline;
  Size window;
  Size sprite;
  bool is_held = false;
  /// The core's object, where it has members that no row shows; empty: made from the row. Not kept in files.
  std::vector<std::byte> core_object = {};
};

/// A run of consecutive steps clamped by the same wall: a bounce is a contact of one step; rest on the floor
/// is one that does not end. All quantities but `last_step` are of its first step.
struct Contact {
  std::int64_t step = 0;
  std::int64_t last_step = 0;
  Wall wall = Wall::ground;
  double t_s = 0.0;
  double x_px = 0.0;
  double y_px = 0.0;
  double vx_before_px_per_s = 0.0;  ///< After gravity and drag, as it met the wall.
  double vy_before_px_per_s = 0.0;
  double vx_after_px_per_s = 0.0;
  double vy_after_px_per_s = 0.0;
  /// >= 0; how far past the wall the unclamped position was. NaN: not known, of a core of one's own.
  double overshoot_px = 0.0;
  bool operator==(const Contact&) const = default;
};

/// Whether they are of the same wall, from the same first to the same last step.
[[nodiscard]] inline bool has_same_steps(const Contact& a, const Contact& b) {
  return a.step == b.step && a.last_step == b.last_step && a.wall == b.wall;
}

/// A trajectory holds no more contacts than this; they are counted all the same.
inline constexpr std::int64_t kContactsRecordedMax = 1'000'000;

}  // namespace hyrax
