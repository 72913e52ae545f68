// The reader's own fling: a hand on the hyrax, frames of any length, and what a replay of them needs.
#pragma once

#include <optional>

#include "tools/hyrax/frame_player.h"
#include "tools/hyrax/hand.h"
#include "tools/hyrax/tape.h"

namespace hyrax {

/// Points are in px of the window, ticks are microseconds.
class Playground {
 public:
  explicit Playground(const Keyframe& start) : player_(start), tape_(start) {}

  /// REQUIRES: not held.
  void grab(ScreenPoint hand, std::int64_t ticks);
  /// REQUIRES: held; ticks do not go backwards.
  void drag(ScreenPoint hand, std::int64_t ticks);
  /// It flies with the hand's velocity. REQUIRES: held.
  void release(ScreenPoint hand, std::int64_t ticks);
  /// REQUIRES: 0 <= dt_s <= kFrameMax_s.
  void frame(double dt_s);

  [[nodiscard]] const Keyframe& now() const { return player_.now(); }
  [[nodiscard]] const Tape& tape() const { return tape_; }

 private:
  struct Hold {
    Hand hand;
    ScreenPoint at;
    Position offset;  ///< Of the sprite's corner from the hand, kept through the drag.
    bool has_moved = false;
  };

  void apply(const Action& action);
  void follow_hand();

  FramePlayer player_;
  Tape tape_;
  std::optional<Hold> hold_;
};

}  // namespace hyrax
