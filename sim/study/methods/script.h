// A scenario laid out frame by frame, so that parts of it can be left out and all else stays where it is.
#pragma once

#include <algorithm>
#include <cstdint>
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
  std::vector<double> frames_s;       ///< As the clock gives them, jitter and all.
  std::vector<double> even_frames_s;  ///< Without jitter; empty where there is none to leave out.
  std::vector<ScriptEvent> events;    ///< In order of time.
  /// Names of what can be left out alone, as "fling, frame 120": an event, or a grab with its release.
  std::vector<std::string> inputs;
  bool is_cut = false;  ///< It is the scenario's first kScriptFramesMax frames.
};

/// A recorded clock's even frames have its mean.
[[nodiscard]] Script script_of(const Scenario& scenario);

/// What of a script is left out, beside parts of the step.
struct Omitted {
  bool jitter = false;
  std::vector<bool> inputs = {};  ///< By their index; shorter than Script::inputs: the others stay.

  [[nodiscard]] bool has_input(std::size_t input) const { return input < inputs.size() && inputs[input]; }
};

/// Plays the script, or its first `frames_max` frames; `on_row(state, contact)` gets every row but the first.
template <class PartSet, class OnRow>
void play(const Script& script, const Constants& constants, const Omitted& omitted, const PartSet& parts,
          const OnRow& on_row, std::size_t frames_max = kScriptFramesMax) {
  const std::vector<double>& frames_s = omitted.jitter ? script.even_frames_s : script.frames_s;
  World world = script.start;
  auto event = script.events.begin();
  const std::size_t frames = std::min(frames_s.size(), frames_max);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    double dt_s = frames_s[frame];
    for (; event != script.events.end() && event->frame == static_cast<std::int64_t>(frame); ++event)
      if (!omitted.has_input(event->input)) {
        apply(event->action, world);
        if (const auto* hitch = std::get_if<Hitch>(&event->action)) dt_s = hitch->dt_s;
      }
    std::uint8_t contact = 0;
    if (!world.is_held) contact = ListingStep(constants, parts, world.bounds())(world.state, dt_s);
    on_row(world.state, contact);
  }
}

}  // namespace hyrax
