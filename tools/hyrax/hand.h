// The hand that drags the hyrax, and the drag.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

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

/// A drag of the hyrax, which keeps its place in the hand. Corners are relative to an origin on the screen,
/// which may change while it is held.
class Hold {
 public:
  /// @param corner of the sprite. REQUIRES: as Hand.
  Hold(std::int64_t ticks_per_s, ScreenPoint hand, std::int64_t ticks, Position corner, ScreenPoint origin)
      : hand_(ticks_per_s, hand, ticks),
        at_(hand),
        offset_{corner.x_px + (origin.x_px - hand.x_px), corner.y_px + (origin.y_px - hand.y_px)} {}

  /// Whether the hand was elsewhere before. REQUIRES: ticks do not go backwards.
  bool move(ScreenPoint to, std::int64_t ticks);
  /// Where the hand puts the corner; nothing if the hand has not moved since the last call.
  [[nodiscard]] std::optional<Position> follow(ScreenPoint origin);
  [[nodiscard]] Velocity velocity(std::int64_t ticks) const { return hand_.velocity(ticks); }

 private:
  Hand hand_;
  ScreenPoint at_;
  Position offset_;  // Of the sprite's corner from the hand.
  bool has_moved_ = false;
};

}  // namespace hyrax
