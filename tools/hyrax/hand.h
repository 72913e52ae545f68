// The hand that drags the hyrax.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "sim/motion/state.h"
#include "tools/hyrax/desk.h"

namespace hyrax {

/// A drag of the hyrax, which keeps its place in the hand. The hand's positions are whole pixels and times
/// are ticks of a clock, so that its velocity is rounded only once. Corners are relative to an origin on the
/// screen, which may change while the hyrax is held.
class Hold {
 public:
  /// @param ticks when the drag began.
  /// @param corner of the sprite.
  /// REQUIRES: ticks_per_s > 0.
  Hold(std::int64_t ticks_per_s, ScreenPoint hand, std::int64_t ticks, Position corner, ScreenPoint origin);

  /// Whether the hand was elsewhere before. A time before that of the last move counts as that one.
  bool move(ScreenPoint to, std::int64_t ticks);
  /// Where the hand puts the corner; nothing if the hand has not moved since the last call.
  [[nodiscard]] std::optional<Position> follow(ScreenPoint origin);
  /// Where the corner was when the drag began.
  [[nodiscard]] Position start(ScreenPoint origin) const { return corner_of(grabbed_at_, origin); }
  /// Mean velocity of the hand over the last 100 ms before `ticks`, or over all of a shorter drag; 0 if it
  /// did not move. Between two positions it moved steadily. A drag shorter than 10 ms counts as 10 ms, so
  /// that a click is not a throw.
  [[nodiscard]] Velocity velocity(std::int64_t ticks) const;

 private:
  struct Sample {
    ScreenPoint at;
    std::int64_t ticks;
  };

  [[nodiscard]] Position corner_of(ScreenPoint hand, ScreenPoint origin) const {
    return {offset_.x_px + (hand.x_px - origin.x_px), offset_.y_px + (hand.y_px - origin.y_px)};
  }

  std::int64_t ticks_per_s_;
  ScreenPoint grabbed_at_;
  std::deque<Sample> samples_;  // The oldest is the first one that still counts.
  Position offset_;             // Of the sprite's corner from the hand.
  bool has_moved_ = false;
};

}  // namespace hyrax
