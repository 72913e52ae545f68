// The hand that drags the hyrax, and how fast it was when it let go.
#pragma once

#include <cstdint>
#include <deque>

#include "sim/scenario/scenario.h"
#include "tools/hyrax/desk.h"

namespace hyrax {

/// Where the pointer was, as whole pixels and ticks of a clock: what the velocity is made of is exact,
/// and one division rounds it.
class Hand {
 public:
  /// @param ticks_per_s of the clock, > 0.
  /// @param ticks when the hand took hold.
  Hand(std::int64_t ticks_per_s, ScreenPoint at, std::int64_t ticks);

  /// REQUIRES: ticks do not go backwards.
  void move(ScreenPoint to, std::int64_t ticks);

  /// Mean velocity over the last 100 ms before `ticks`, or over the whole of a shorter drag: from where
  /// the pointer was then to where it is. A hand that stood still for that long gives 0. A drag of less
  /// than 10 ms counts as one of 10 ms, so that a click does not throw.
  [[nodiscard]] Velocity velocity(std::int64_t ticks) const;

 private:
  struct Sample {
    ScreenPoint at;
    std::int64_t ticks;
  };

  std::int64_t ticks_per_s_;
  std::int64_t grabbed_ticks_;
  std::deque<Sample> samples_;  // As far back as the first one that still counts.
};

}  // namespace hyrax
