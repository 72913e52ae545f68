#include "sim/study/methods/script.h"

#include <algorithm>
#include <numeric>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

std::vector<double> even_frames(const Scenario& scenario, const std::vector<double>& frames_s) {
  if (scenario.clock.jitter) return std::vector<double>(frames_s.size(), base_dt_s(scenario.clock));
  if (!std::holds_alternative<RecordedSteps>(scenario.clock.base) || frames_s.empty()) return {};
  const double sum_s = std::accumulate(frames_s.begin(), frames_s.end(), 0.0);
  return std::vector<double>(frames_s.size(), sum_s / static_cast<double>(frames_s.size()));
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
  script.even_frames_s = even_frames(scenario, script.frames_s);
  for (std::size_t event = 0; event < frames.size() && frames[event] < kScriptFramesMax; ++event) {
    const Action& action = scenario.events[event].action;
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

}  // namespace hyrax
