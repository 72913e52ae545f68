// The hyrax on a desk: what hand, menu, clock and screen do to it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/hyrax/desk.h"
#include "tools/hyrax/frame_timer.h"
#include "tools/hyrax/hand.h"
#include "tools/hyrax/session.h"

namespace hyrax {

/// How it is drawn.
enum class Pose { fly, held, stand, sleep };

/// Turns what happens on a screen into inputs and frames of a session. Knows no system: points come in
/// px of the screen, time in ticks of a clock that its owner reads.
class Pet {
 public:
  /// It begins at the top of its desk, in the middle, and falls.
  /// REQUIRES: ticks_per_s > 0.
  Pet(const Desk& desk, std::int64_t ticks_per_s, std::int64_t ticks);

  // The hand. REQUIRES: grab while not held, the others while held.
  void grab(ScreenPoint hand, std::int64_t ticks);
  void drag(ScreenPoint hand, std::int64_t ticks);
  /// It flies from here on with the hand's velocity, on the desk that it was let go over.
  void let_go(ScreenPoint hand, std::int64_t ticks, const Desk& desk);
  /// The hand was taken away: it falls from where it is.
  void drop(std::int64_t ticks);

  // The menu.
  void fling(const Velocity& velocity, std::int64_t ticks);
  /// To where it began, and still. Whoever holds it, holds it no longer.
  void reset(std::int64_t ticks);
  void pause() { is_paused_ = true; }
  void resume(std::int64_t ticks);

  /// The screen: a desk of another size or place. The same desk is no input.
  void move_to(const Desk& desk, std::int64_t ticks);

  /// The hyrax's time stood still until now, as the machine's did while it was suspended.
  void skip_time(std::int64_t ticks) { timer_.restart(ticks); }

  /// Plays a frame, if it is awake.
  void frame(std::int64_t ticks);

  /// Whether no frame is to be played until an input comes: it is paused, or has kept its place for
  /// Session::kStillFrames frames.
  [[nodiscard]] bool is_asleep() const { return is_paused_ || session_.is_still(); }
  [[nodiscard]] bool is_paused() const { return is_paused_; }
  [[nodiscard]] bool is_held() const { return hold_.has_value(); }
  [[nodiscard]] bool faces_left() const { return faces_left_; }
  [[nodiscard]] Pose pose() const;
  [[nodiscard]] const Desk& desk() const { return desk_; }
  /// Its top left corner.
  [[nodiscard]] ScreenPoint place() const { return on_screen(desk_, position()); }
  /// What was done to it before the last frame that was played.
  [[nodiscard]] const std::vector<Action>& inputs_of_frame() const { return inputs_of_frame_; }
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] const Session& session() const { return session_; }

 private:
  struct Hold {
    Hand hand;
    ScreenPoint at;
    Position offset;  ///< Of the sprite's corner from the hand, kept through the drag.
    bool has_moved = false;
  };

  [[nodiscard]] Position position() const;
  void wake(std::int64_t ticks);
  void apply(const Action& action);
  void follow_hand();
  void release(const Velocity& velocity, std::int64_t ticks);

  Desk desk_;
  std::int64_t ticks_per_s_;
  FrameTimer timer_;
  Session session_;
  std::optional<Hold> hold_;
  bool is_paused_ = false;
  bool faces_left_ = false;
  int ground_frames_ = 0;       // On the ground, as the eye sees it, in a row.
  std::vector<Action> inputs_;  // Of the frame to come.
  std::vector<Action> inputs_of_frame_;
};

}  // namespace hyrax
