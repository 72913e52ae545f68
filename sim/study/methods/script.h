// A scenario laid out frame by frame, so that parts of it can be left out and all else stays where it is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "sim/motion/step.h"
#include "sim/scenario/apply.h"

namespace hyrax {

struct ScriptEvent {
  std::int64_t frame = 0;
  Action action;
  std::size_t input = 0;  ///< Index into Script::inputs.
};

/// Longer scenarios are cut to so many frames.
inline constexpr std::int64_t kScriptFramesMax = 100'000;

struct Script {
  std::string name;
  World start;
  std::vector<double> frames_s;     ///< As they are played, jitter and hitches and all.
  std::vector<ScriptEvent> events;  ///< In order of time.
  /// Names of what can be left out alone, as "fling, frame 120": an event, or a grab with its release.
  std::vector<std::string> inputs;
  double even_frame_s = 0.0;  ///< Of the clock without jitter; of a recorded clock the mean.
  bool is_jittered = false;   ///< By the clock's jitter or as recorded.
  bool is_cut = false;        ///< It is the scenario's first kScriptFramesMax frames.
};

[[nodiscard]] Script script_of(const Scenario& scenario);

/// The script without those of its inputs that are true, and without jitter if that is. All else stays at its
/// time in s: without jitter the frames between two events take equally long, as near to even_frame_s as they
/// fit; without a hitch its time passes in such frames. REQUIRES: as many as Script::inputs.
[[nodiscard]] Script without(const Script& script, const std::vector<bool>& inputs, bool jitter);

/// A frame as it was played.
struct ScriptFrame {
  State from;  ///< With the frame's events.
  State to;
  double dt_s = 0.0;
  std::uint8_t contact = 0;
};

/// Plays the script, or its first `frames_max` frames; `on_frame(ScriptFrame)` gets every one. Not by Replay:
/// no core has a step without one of its parts, and what a part costs is measured here, with nothing beside
/// it.
template <class PartSet, class OnFrame>
void play(const Script& script, const Constants& constants, const PartSet& parts, const OnFrame& on_frame,
          std::size_t frames_max = std::numeric_limits<std::size_t>::max()) {
  World world = script.start;
  auto event = script.events.begin();
  const std::size_t frames = std::min(script.frames_s.size(), frames_max);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (; event != script.events.end() && event->frame == static_cast<std::int64_t>(frame); ++event)
      apply(event->action, world);
    ScriptFrame played{.from = world.state, .to = {}, .dt_s = script.frames_s[frame]};
    if (!world.is_held)
      played.contact = ListingStep(constants, parts, world.bounds())(world.state, played.dt_s);
    played.to = world.state;
    on_frame(played);
  }
}

}  // namespace hyrax
