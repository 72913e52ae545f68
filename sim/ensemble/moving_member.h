// A member on its way: what one stretch without inputs hands to the next.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/ensemble/ensemble.h"
#include "sim/ensemble/lanes.h"
#include "sim/motion/state.h"
#include "sim/scenario/frame_clock.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

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

}  // namespace hyrax
