// Plays frames one by one, as a replay of the resulting scenario does.
#pragma once

#include <cassert>
#include <optional>

#include "tools/hyrax/frame_player.h"
#include "tools/hyrax/recording.h"

namespace hyrax {

/// Plays frames that are not known beforehand with the step and the inputs of a replay, and records them. So
/// a replay computes what was shown.
class Session {
 public:
  /// After so many frames without motion the hyrax may sleep.
  static constexpr int kStillFrames = 60;

  Session(const Core& core, const Keyframe& start);

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

  /// Starts a recording. REQUIRES: !is_recording(). ERRORS: Failure(bad_input) if the file exists.
  void start_recording(const std::string& path, ScenarioSaver& saver) {
    assert(!is_recording());
    recording_.emplace(path, now(), saver);
  }
  [[nodiscard]] bool is_recording() const { return recording_.has_value(); }
  /// REQUIRES: is_recording().
  [[nodiscard]] Recording& recording() {
    assert(is_recording());
    return *recording_;
  }
  /// REQUIRES: is_recording(). ERRORS: Failure(cannot_access); the recording has ended nevertheless.
  void finish_recording();
  /// Finishes the file of a recording and continues in a new one beside it. REQUIRES: is_recording().
  /// ERRORS: Failure(cannot_access) for the finished file; the new recording has begun nevertheless.
  void continue_recording();

 private:
  FramePlayer player_;
  Ring ring_;
  std::optional<Recording> recording_;
  int still_frames_ = 0;
};

}  // namespace hyrax
