// What a kernel moves: up to 32 members at once, one a lane, each quantity an array over the lanes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/motion/state.h"

namespace hyrax {

inline constexpr std::size_t kLanes = 32;

/// Which numbers a kernel reduces on the way.
enum class Detail : std::uint8_t {
  final,    ///< None: the state alone.
  tracked,  ///< Contacts, and since when the sprite has settled.
  extremes  ///< These, and the extremes of position and speed.
};

/// Where the dt of a lane's frames comes from: it has one, or it draws or reads one a frame
/// (sim/scenario/frame_clock.h).
enum class LaneClock : std::uint8_t { fixed, uniform, normal, missed_frames, trace };

/// Bits of the walls that clamped a step, 16 bits apart so that they can be summed over a block.
inline constexpr int kWallBits = 16;
constexpr std::uint64_t wall_bit(std::size_t wall) { return std::uint64_t{1} << (kWallBits * wall); }

struct alignas(64) Lanes {
  using Reals = std::array<double, kLanes>;
  using Bits = std::array<std::uint64_t, kLanes>;

  Reals x_px, y_px, vx_px_per_s, vy_px_per_s;
  Reals right_px, bottom_px;  ///< The bounds.
  Reals dt_s;                 ///< Of every frame, or the base of a jittered clock.

  // Drawn dt.
  Reals amount;         ///< Of the jitter.
  Bits draw;            ///< The generator before its next draw: seed + draws * gamma.
  Bits frame;           ///< The next frame of the trace.
  const double* trace;  ///< The dt of every frame.

  Constants constants;  ///< Of the core.

  // Detail::tracked.
  Bits walls;  ///< That clamped the latest step.
  Bits begun;  ///< Contacts that began in this block, a sum of wall bits.
  Reals anchor_x_px, anchor_y_px;
  Reals moved;  ///< The step of this block, from 1, whose row became the anchor of rest; 0: none.
  // With a drawn dt, the time of the run (sim/scenario/frame_clock.h, Timeline) and of the anchor.
  Reals time_base_s, time_comp_s, time_dt_s, time_frames, anchor_t_s;

  // Detail::extremes.
  Reals x_min_px, x_max_px, y_min_px, y_max_px;
  Reals speed_squared_max;

  // Of a block at fixed dt, a bit a lane.
  Reals vy_before_px_per_s;  ///< One step before the latest.
  std::uint32_t
      is_at_rest;         ///< On the ground in both of the last two steps, before which y and vy were as now.
  std::uint32_t repeats;  ///< The whole state is that before the block.
};

/// Steps of a block are counted in wall bits.
inline constexpr std::int64_t kBlockStepsMax = (1 << kWallBits) - 1;

/// The kernels of one instruction set. All give the same bits.
struct KernelSet {
  const char* name;  ///< As "AVX2".
  /// Plays `steps` frames of every lane. REQUIRES: 1 <= steps <= kBlockStepsMax.
  void (*play)(Lanes& lanes, std::int64_t steps, Detail detail, LaneClock clock);
  /// Plays frames of lanes that slide on the ground: they meet no wall in x. Sets `moved` as play does, and
  /// is_at_rest where x did not change in the last step.
  void (*slide)(Lanes& lanes, std::int64_t steps, bool is_tracked);
  /// Plays frames of lanes on the ground whose x does not change: only vx. Sets `repeats` where vx did not
  /// change in the last step.
  void (*slow_down)(Lanes& lanes, std::int64_t steps);
};

/// The kernels that this machine can run, the fastest first; never empty.
[[nodiscard]] std::span<const KernelSet> kernel_sets();

}  // namespace hyrax
