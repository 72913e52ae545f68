// The hand that drags the hyrax.
#pragma once

#include <cstdint>
#include <deque>

#include "sim/motion/state.h"
#include "tools/hyrax/desk.h"

namespace hyrax {

/// The hand that drags the hyrax. Positions are whole pixels and times are ticks of a clock, so that the
/// velocity is rounded only once.
class Hand {
 public:
  /// @param ticks when the drag began.
  /// REQUIRES: ticks_per_s > 0.
  Hand(std::int64_t ticks_per_s, ScreenPoint at, std::int64_t ticks);

  /// REQUIRES: ticks do not go backwards.
  void move(ScreenPoint to, std::int64_t ticks);

  /// Mean velocity of the pointer over the last 100 ms before `ticks`, or over all of a shorter drag; 0 if it
  /// did not move. A drag shorter than 10 ms counts as 10 ms, so that a click is not a throw.
  [[nodiscard]] Velocity velocity(std::int64_t ticks) const;

 private:
  struct Sample {
    ScreenPoint at;
    std::int64_t ticks;
  };

  std::int64_t ticks_per_s_;
  std::int64_t grabbed_ticks_;
  std::deque<Sample> samples_;  // The oldest is the first one that still counts.
};

}  // namespace hyrax
