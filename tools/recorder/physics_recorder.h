// Records a program that moves a `class physics` (sim/physics/physics.h), for Linux and Windows: a header of
// hyrax::recorder, which README.md describes.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "sim/core/core_of.h"
#include "tools/recorder/frame_player.h"
#include "tools/recorder/program_recorder.h"

namespace hyrax {

/// The part that knows no class.
class FrameRecorder : public ProgramRecorder<Tape> {
 protected:
  FrameRecorder(const std::string& path, const Core& core, const State& start, Size window, Size sprite);

  /// What the program did since the last frame, as inputs of the next one. @param object as
  /// Keyframe::core_object.
  void begin_frame(const State& body, std::vector<std::byte> object, double dt_s, const Size& window,
                   const Size& sprite, bool is_held);
  void end_frame(const State& body, double dt_s);

 private:
  FramePlayer player_;
};

/// The recording of one body. It never changes the body, nor what update makes of it.
template <class Physics>
class PhysicsRecorder : public FrameRecorder {
 public:
  /// Starts at the state of the body. @param path of the file, UTF-8.
  PhysicsRecorder(const std::string& path, const Physics& body, Size window, Size sprite)
      : FrameRecorder(path, core_of<Physics>("recorded", built_core_record()), state_of(body), window,
                      sprite) {}

  /// A frame: calls body.update with these arguments. What setPos, setVelocity and resetVelocity did to the
  /// body before it, and another size, are events of the scenario.
  void update(Physics& body, double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
              int sprite_height_px) {
    begin_frame(state_of(body), object_of(body), dt_s, {window_width_px, window_height_px},
                {sprite_width_px, sprite_height_px}, false);
    body.update(dt_s, window_width_px, window_height_px, sprite_width_px, sprite_height_px);
    end_frame(state_of(body), dt_s);
  }
  /// A frame in which the body is held, as by the mouse: without a call of update.
  void hold(const Physics& body, double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
            int sprite_height_px) {
    begin_frame(state_of(body), object_of(body), dt_s, {window_width_px, window_height_px},
                {sprite_width_px, sprite_height_px}, true);
    end_frame(state_of(body), dt_s);
  }

 private:
  static State state_of(const Physics& body) { return {body.x(), body.y(), body.vx(), body.vy()}; }
  static std::vector<std::byte> object_of(const Physics& body) {
    std::vector<std::byte> object(sizeof body);
    std::memcpy(object.data(), &body, sizeof body);
    return object;
  }
};

}  // namespace hyrax
