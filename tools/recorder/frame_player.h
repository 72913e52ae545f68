// Plays frames that are not known beforehand, as a replay of them does.
#pragma once

#include <utility>
#include <vector>

#include "sim/core/core.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// Plays single frames with the step and the inputs of a replay.
class FramePlayer {
 public:
  FramePlayer(const Core& core, const Keyframe& start) : stepper_(core.stepper), now_(start) {}

  /// The state before the next frame.
  [[nodiscard]] const Keyframe& now() const { return now_; }

  /// An input of the next frame. REQUIRES: no hitch; no grab while held, no release while not.
  void apply(const Action& action);
  /// Plays a frame of `dt_s` seconds, 0 .. kFrameMax_s.
  void advance(double dt_s);
  /// Goes on from the state of another body. @param object as Keyframe::core_object.
  void go_on_from(const State& state, std::vector<std::byte> object) {
    set_state(now_.row, state);
    now_.core_object = std::move(object);
  }

 private:
  std::shared_ptr<const Stepper> stepper_;
  Keyframe now_;
  RowBlock row_;  // Of the frame being played.
  StretchLog log_;
  RestAnchor rest_;
};

}  // namespace hyrax
