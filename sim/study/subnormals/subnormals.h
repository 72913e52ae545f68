// Where the horizontal speed of a sprite on the floor ends, and what a step with it costs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/study/methods/cost.h"

namespace hyrax {

/// A fling on a display, left alone. Steps are row numbers.
struct SlideEnd {
  double rate_hz = 0.0;
  std::int64_t subnormal_step = -1;  ///< First row with a subnormal vx; -1: none.
  std::int64_t stuck_step = -1;      ///< First row whose vx never changes again; -1: none.
  double stuck_vx_px_per_s = 0.0;
  double moved_px = 0.0;         ///< Way from the first subnormal row on.
  std::vector<double> t_s;       ///< Every 16th row, to the one at which vx is stuck:
  std::vector<double> exponent;  ///< log10 |vx|.
};

/// Played for up to 8,000 steps: on the floor vx shrinks to 0.7992 of it a step, so that 3,200 suffice.
[[nodiscard]] SlideEnd slide_end(double rate_hz);

/// The largest |vx| that neither drag nor friction changes: so many units of the last place that rounding to
/// whole units gives each factor's loss back.
[[nodiscard]] double largest_stuck_vx_px_per_s();

/// Cost of a step on the floor, all timed in random order.
struct SlideCost {
  std::string what;
  std::string with;        ///< Which vx.
  MedianEstimate step_ns;  ///< NaN: not measured, the clock was not steady.
  MedianEstimate ratio;    ///< To the same with vx = 0, round by round.
};
struct SlideCosts {
  std::vector<SlideCost> costs;
  ClockProbe probe;
};
[[nodiscard]] SlideCosts measure_slide_costs(const NanosecondClock& now_ns, bool is_quick);

}  // namespace hyrax
