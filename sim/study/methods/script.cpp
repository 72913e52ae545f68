#include "sim/study/methods/script.h"

#include <cmath>
#include <numeric>
#include <span>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

// Frames of equal length for a stretch of time, as near to one of `about_s` as they fit.
void append_even(std::vector<double>& frames_s, double stretch_s, double about_s) {
  if (stretch_s == 0.0) return frames_s.push_back(0.0);
  const double count = std::round(std::min(stretch_s / about_s, static_cast<double>(kScriptFramesMax)));
  const auto frames = static_cast<std::size_t>(std::max(count, 1.0));
  frames_s.insert(frames_s.end(), frames, stretch_s / static_cast<double>(frames));
}

bool is_even(std::span<const double> frames_s) {
  return std::all_of(frames_s.begin(), frames_s.end(),
                     [first = frames_s.front()](double frame_s) { return frame_s == first; });
}

}  // namespace

Script script_of(const Scenario& scenario) {
  Script script;
  script.name = scenario.name;
  script.start = {.state = start_state(scenario), .window = scenario.window, .sprite = scenario.sprite};
  const std::int64_t steps = step_count(scenario);
  const std::vector<std::int64_t> frames = schedule_events(scenario, steps).frames;
  script.is_cut = steps > kScriptFramesMax;
  const FrameClock clock(scenario.clock);
  for (std::int64_t frame = 0; frame < std::min(steps, kScriptFramesMax); ++frame)
    script.frames_s.push_back(clock.dt_s(frame));
  const double sum_s = std::accumulate(script.frames_s.begin(), script.frames_s.end(), 0.0);
  const bool is_recorded = std::holds_alternative<RecordedSteps>(scenario.clock.base);
  script.is_jittered = !clock.is_fixed() && sum_s > 0.0;
  script.even_frame_s = is_recorded || base_dt_s(scenario.clock) == 0.0
                            ? sum_s / static_cast<double>(script.frames_s.size())
                            : base_dt_s(scenario.clock);
  for (std::size_t event = 0; event < frames.size() && frames[event] < kScriptFramesMax; ++event) {
    const Action& action = scenario.events[event].action;
    if (const auto* const hitch = std::get_if<Hitch>(&action))
      script.frames_s[static_cast<std::size_t>(frames[event])] = hitch->dt_s;
    // A release belongs to the grab before it: without it the sprite would be held for good.
    if (!std::holds_alternative<Release>(action))
      script.inputs.push_back(
          {(std::holds_alternative<Grab>(action) ? "hold" : std::string(name_of(action))) + ", frame " +
           std::to_string(frames[event])});
    std::size_t input = script.inputs.size() - 1;
    if (std::holds_alternative<Release>(action))
      for (const ScriptEvent& before : script.events)
        if (std::holds_alternative<Grab>(before.action)) input = before.input;
    script.events.push_back({frames[event], action, input});
  }
  return script;
}

Script without(const Script& script, const std::vector<bool>& inputs, bool jitter) {
  Script left = script;
  left.frames_s.clear();
  left.events.clear();
  auto event = script.events.begin();
  for (std::size_t frame = 0; frame < script.frames_s.size();) {
    bool is_hitch = false, is_hitch_omitted = false;
    for (; event != script.events.end() && event->frame == static_cast<std::int64_t>(frame); ++event) {
      const bool is_omitted = inputs[event->input];
      if (!is_omitted) left.events.push_back({std::ssize(left.frames_s), event->action, event->input});
      if (!std::holds_alternative<Hitch>(event->action)) continue;
      is_hitch = true;
      is_hitch_omitted = is_omitted;
    }
    if (is_hitch_omitted)
      append_even(left.frames_s, script.frames_s[frame], script.even_frame_s);
    else if (is_hitch)
      left.frames_s.push_back(script.frames_s[frame]);
    if (is_hitch) ++frame;
    const std::size_t end =
        event == script.events.end() ? script.frames_s.size() : static_cast<std::size_t>(event->frame);
    const std::span stretch(script.frames_s.data() + frame, end - frame);
    if (jitter && !stretch.empty() && !is_even(stretch))
      append_even(left.frames_s, std::accumulate(stretch.begin(), stretch.end(), 0.0), script.even_frame_s);
    else
      left.frames_s.insert(left.frames_s.end(), stretch.begin(), stretch.end());
    frame = end;
  }
  return left;
}

}  // namespace hyrax
