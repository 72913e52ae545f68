// The hyrax's life, frame by frame, in exactly the words of a scenario.
#pragma once

#include <optional>

#include "sim/replay/kernel.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/state_hash.h"
#include "tools/hyrax/recording.h"
#include "tools/hyrax/ring.h"

namespace hyrax {

/// Plays frames that are not known beforehand by the replay's own step and the replay's own effect of
/// inputs, and hands each to those who keep it. So what is shown is what a replay of it computes.
class Session {
 public:
  /// A hyrax that kept its place for so many frames may sleep.
  static constexpr int kStillFrames = 60;

  explicit Session(const Keyframe& start);

  /// The state as the next frame finds it.
  [[nodiscard]] const Keyframe& now() const { return now_; }

  /// An input of the frame to come. REQUIRES: no hitch; no grab while held, no release while not.
  void apply(const Action& action);
  /// Plays a frame of `dt_s` seconds, 0 .. kFrameMax_s.
  void advance(double dt_s);

  /// Whether x and y kept the same bits for the last kStillFrames frames, without input. Frames of no
  /// time are not counted: they are no sign of rest.
  [[nodiscard]] bool is_still() const { return still_frames_ >= kStillFrames; }
  /// Counts the frames without motion anew, as an input does.
  void wake() { still_frames_ = 0; }

  /// The last minutes.
  [[nodiscard]] Tape just_happened() const { return ring_.tape(); }

  /// Records from here on. REQUIRES: it records nothing yet. ERRORS: Failure(bad_input) if the file exists.
  void start_recording(const std::string& path, ScenarioSaver& saver) {
    recording_.emplace(path, now_, saver);
  }
  [[nodiscard]] bool is_recording() const { return recording_.has_value(); }
  /// REQUIRES: is_recording().
  [[nodiscard]] Recording& recording() { return *recording_; }
  /// REQUIRES: is_recording(). ERRORS: Failure(cannot_access); it is ended all the same.
  void finish_recording();
  /// Ends the file of a recording and goes on in a new one beside it. REQUIRES: is_recording().
  /// ERRORS: Failure(cannot_access) for the file that ended; the new recording has begun all the same.
  void continue_recording();

 private:
  Keyframe now_;
  RowBlock row_;  // Of the frame that is played.
  StretchLog log_;
  RestAnchor rest_;
  Ring ring_;
  std::optional<Recording> recording_;
  int still_frames_ = 0;
};

}  // namespace hyrax
