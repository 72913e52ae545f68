// The hyrax on a desk: what hand, menu, clock and screen do to it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/hyrax/desk.h"
#include "tools/hyrax/hand.h"
#include "tools/recorder/frame_player.h"
#include "tools/recorder/recording.h"

namespace hyrax {

/// Plays frames that are not known beforehand with the step and the inputs of a replay, and records them. So
/// a replay computes what was shown.
class Session {
 public:
  /// After so many frames without motion the hyrax may sleep.
  static constexpr int kStillFrames = 60;

  Session(const Core& core, const Keyframe& start) : player_(core, start), ring_(start) {}

  /// The state before the next frame.
  [[nodiscard]] const Keyframe& now() const { return player_.now(); }

  /// An input of the next frame. REQUIRES: no hitch; no grab while held, no release while not.
  void apply(const Action& action);
  /// Plays a frame of `dt_s` seconds, 0 .. kFrameMax_s.
  void advance(double dt_s);

  /// Whether x and y kept the same bits for the last kStillFrames frames, without input. Zero-length frames
  /// are not counted.
  [[nodiscard]] bool is_still() const { return still_frames_ >= kStillFrames; }
  /// Restarts the count of frames without motion, as an input does.
  void wake() { still_frames_ = 0; }

  /// The last minutes.
  [[nodiscard]] Tape just_happened() const { return ring_.tape(); }

  /// The recording that gets inputs and frames as well; nothing: none. See Recorder.
  [[nodiscard]] std::optional<Recording>& recording() { return recording_; }
  [[nodiscard]] bool is_recording() const { return recording_.has_value(); }

 private:
  FramePlayer player_;
  Ring ring_;
  std::optional<Recording> recording_;
  int still_frames_ = 0;
};

/// What is done several times a second: due at first, and again a period after it was last done.
class Repeated {
 public:
  Repeated(std::int64_t ticks_per_s, std::int64_t times_per_s) : period_ticks_(ticks_per_s / times_per_s) {}

  [[nodiscard]] bool is_due(std::int64_t now_ticks) const { return now_ticks >= due_ticks_; }
  void done(std::int64_t now_ticks) { due_ticks_ = now_ticks + period_ticks_; }

 private:
  std::int64_t period_ticks_;
  std::int64_t due_ticks_ = 0;
};

struct DueTimes {
  std::int64_t last_due_ticks;
  std::int64_t now_ticks;
  std::int64_t period_ticks;
};

/// When the next frame is due: a period after the last due time, so that the rate is kept; after a late frame
/// a period from now. A short frame after a late one would make a settled hyrax hop.
[[nodiscard]] std::int64_t next_due_ticks(const DueTimes& times);

/// How the hyrax is drawn.
enum class Pose { fly, held, stand, sleep };

/// The number of its picture in hyrax.rc for that width: the smallest one that is not scaled up, or that of
/// 200 %.
[[nodiscard]] int picture_of(Pose pose, int width_px);

/// Turns events on a screen into inputs and frames of a session. Independent of the system: points are in px
/// of the screen, times in ticks of a clock that the caller reads.
class Pet {
 public:
  /// It starts at the top of its desk, in the middle, and falls.
  /// REQUIRES: ticks_per_s > 0.
  Pet(const Core& core, const Desk& desk, std::int64_t ticks_per_s, std::int64_t ticks);

  // The hand. REQUIRES: grab while not held, the others while held.
  void grab(ScreenPoint hand, std::int64_t ticks);
  void drag(ScreenPoint hand, std::int64_t ticks);
  /// It flies with the hand's velocity, on the desk below the pointer; from the edge, if it was dragged past
  /// one.
  void let_go(ScreenPoint hand, std::int64_t ticks, const Desk& desk);
  /// The drag was interrupted: it falls from where it is.
  void drop(std::int64_t ticks);
  /// The drag was cancelled: it falls from where it was grabbed.
  void cancel(std::int64_t ticks);

  // The menu.
  void fling(const Velocity& velocity, std::int64_t ticks);
  /// Back to its start, at zero speed, and no longer held.
  void reset(std::int64_t ticks);
  void pause() { is_paused_ = true; }
  void resume(std::int64_t ticks);

  /// The desks of all monitors, between which it flies where they touch; at first only its own. If that is no
  /// longer among them, it moves to `nearest`. A pause continues.
  void use_monitors(std::vector<Desk> monitors, const Desk& nearest, std::int64_t ticks);

  /// The time until now does not count, as while the machine was suspended.
  void skip_time(std::int64_t ticks) { last_ticks_ = ticks; }

  /// Plays a frame unless it is asleep. A longer one than 0.1 s counts as 0.1 s: after a stall of the machine
  /// a long step would launch it.
  void frame(std::int64_t ticks);

  /// Whether no frame is played until the next input: it is paused, or has not moved for
  /// Session::kStillFrames frames.
  [[nodiscard]] bool is_asleep() const { return is_paused_ || session_.is_still(); }
  [[nodiscard]] bool is_paused() const { return is_paused_; }
  [[nodiscard]] bool is_held() const { return hold_.has_value(); }
  [[nodiscard]] bool faces_left() const { return faces_left_; }
  [[nodiscard]] Pose pose() const;
  [[nodiscard]] const Desk& desk() const { return desk_; }
  /// Its top left corner.
  [[nodiscard]] ScreenPoint place() const { return on_screen(desk_, position()); }
  /// The middle of the sprite.
  [[nodiscard]] ScreenPoint middle() const {
    return {place().x_px + desk_.sprite.width_px / 2, place().y_px + desk_.sprite.height_px / 2};
  }
  /// The inputs of the last frame that was played.
  [[nodiscard]] const std::vector<Action>& inputs_of_frame() const { return inputs_of_frame_; }
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] const Session& session() const { return session_; }

 private:
  [[nodiscard]] Position position() const;
  void move_to(const Desk& desk, std::int64_t ticks);
  void wake(std::int64_t ticks);
  void apply(const Action& action);
  void follow_hand();
  void stay_inside();
  void cross_borders(double dt_s);
  void release(const Velocity& velocity, std::int64_t ticks);

  Desk desk_;
  std::vector<Desk> monitors_;
  std::int64_t ticks_per_s_;
  std::int64_t last_ticks_;  // The next frame begins here; time before it belongs to none.
  Session session_;
  std::optional<Hold> hold_;
  bool is_paused_ = false;
  bool faces_left_ = false;
  int ground_frames_ = 0;       // Consecutive frames on the ground, to the eye.
  std::vector<Action> inputs_;  // Of the next frame.
  std::vector<Action> inputs_of_frame_;
};

}  // namespace hyrax
