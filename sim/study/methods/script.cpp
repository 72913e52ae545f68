#include "sim/study/methods/script.h"

#include <algorithm>
#include <numeric>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

constexpr std::string_view kActionNames[] = {"fling", "place", "stop", "resize", "hitch", "hold", "hold"};

struct Effect {
  World& world;
  double& dt_s;

  void operator()(const Fling& fling) const { set(fling.velocity); }
  void operator()(const Place& place) const {
    world.state.x_px = place.position.x_px;
    world.state.y_px = place.position.y_px;
  }
  void operator()(const Stop&) const { set({}); }
  void operator()(const Resize& resize) const {
    world.window = resize.window.value_or(world.window);
    world.sprite = resize.sprite.value_or(world.sprite);
  }
  void operator()(const Hitch& hitch) const { dt_s = hitch.dt_s; }
  void operator()(const Grab&) const {
    set({});
    world.is_held = true;
  }
  void operator()(const Release& release) const {
    set(release.velocity);
    world.is_held = false;
  }

 private:
  void set(const Velocity& velocity) const {
    world.state.vx_px_per_s = velocity.vx_px_per_s;
    world.state.vy_px_per_s = velocity.vy_px_per_s;
  }
};

std::vector<double> even_frames(const Scenario& scenario, const std::vector<double>& frames_s) {
  if (scenario.clock.jitter) return std::vector<double>(frames_s.size(), base_dt_s(scenario.clock));
  if (!std::holds_alternative<RecordedSteps>(scenario.clock.base) || frames_s.empty()) return {};
  const double sum_s = std::accumulate(frames_s.begin(), frames_s.end(), 0.0);
  return std::vector<double>(frames_s.size(), sum_s / static_cast<double>(frames_s.size()));
}

}  // namespace

void happen(const Action& action, World& world, double& dt_s) { std::visit(Effect{world, dt_s}, action); }

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
    // A release belongs to the grab before it: held for good is another scene.
    if (!std::holds_alternative<Release>(action))
      script.inputs.push_back(
          {std::string(kActionNames[action.index()]) + ", frame " + std::to_string(frames[event])});
    std::size_t input = script.inputs.size() - 1;
    if (std::holds_alternative<Release>(action))
      for (const ScriptEvent& before : script.events)
        if (std::holds_alternative<Grab>(before.action)) input = before.input;
    script.events.push_back({frames[event], action, input});
  }
  return script;
}

}  // namespace hyrax
