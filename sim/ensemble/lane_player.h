// Plays many members by a kernel: fills its lanes, and takes a member out as soon as its end is known.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/ensemble/ensemble.h"
#include "sim/ensemble/lanes.h"
#include "sim/motion/state.h"
#include "sim/scenario/frame_clock.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

/// A member on its way: what goes on from one stretch without inputs to the next.
struct MovingMember {
  World world;
  std::int64_t frame = 0;            ///< The next one.
  std::int64_t steps = 0;            ///< Of the run.
  double base_dt_s = 0.0;            ///< Of a clock that is no trace.
  Jitter jitter;                     ///< Of a jittered clock.
  std::optional<double> hitch_dt_s;  ///< Of the next frame.
  std::uint64_t walls = 0;           ///< Wall bits of the latest row.
  Timeline timeline;
  RestAnchor rest;
  MemberResult* result = nullptr;  ///< Its contacts and extremes so far; the speed's is squared.
};

/// A member, and frames to play without inputs.
struct Leg {
  MovingMember* member = nullptr;
  double dt_s = 0.0;  ///< Of every frame, or the base of a jittered clock.
  std::int64_t frames = 0;
};

/// At fixed dt, three things are left out, and the results have the same bits all the same:
/// - On the ground y and vy depend on each other only, and repeat after one step or two. From there on, if no
///   wall in x can be reached, only x and vx are computed.
/// - When x no longer changes only vx is computed, until it does not change either.
/// - Frames of a state that repeats exactly.
class LanePlayer {
 public:
  LanePlayer(const KernelSet& kernels, const Constants& constants, Detail detail)
      : kernels_(kernels), constants_(constants), detail_(detail) {}

  /// Plays each leg's frames. Members are not held. `trace` is used by LaneClock::trace only.
  /// REQUIRES: legs of different members.
  StepTally play(std::span<const Leg> legs, LaneClock clock, const double* trace);

 private:
  class Flying;
  class Sliding;
  class Slowing;

  Lanes lanes_{};
  const KernelSet& kernels_;
  Constants constants_;
  Detail detail_;
  std::vector<Leg> slides_;   // What is left of legs on the ground: y and vy repeat,
  std::vector<Leg> slowing_;  // and x, too.
};

}  // namespace hyrax
