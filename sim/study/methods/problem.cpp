#include "sim/study/methods/problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/reference/model.h"
#include "sim/scenario/apply.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

constexpr Size kScreen{1920, 1080};
constexpr Size kSprite{128, 128};
constexpr std::int64_t kFramesMax = 10'000'000;  // A scenario of very short frames could have any number.

Problem on_desktop(const std::string& name, const std::string& label, const State& start, double duration_s,
                   const Size& window = kScreen) {
  Problem problem;
  problem.name = name;
  problem.label = label;
  problem.start = start;
  problem.stages = {Stage{.duration_s = duration_s, .bounds = bounds_of(window, kSprite)}};
  return problem;
}

// Coordinates stay as small as the flight allows, so that rounding does.
Problem open_sky(const std::string& name, const std::string& label, const State& start, double duration_s) {
  Problem problem = on_desktop(name, label, start, duration_s, {1'000'000, 1'000'000});
  problem.is_free_flight = true;
  return problem;
}

// The scenario's jitter, its size independent of the frame.
Jitter per_frame(Jitter jitter, double dt_s) {
  if (jitter.kind == Jitter::Kind::normal) jitter.amount /= dt_s;
  return jitter;
}

Jitter of_frame(Jitter jitter, double dt_s) {
  if (jitter.kind == Jitter::Kind::normal) jitter.amount *= dt_s;
  return jitter;
}

}  // namespace

double Problem::duration_s() const {
  double sum_s = 0.0;
  for (const Stage& stage : stages) sum_s += stage.duration_s;
  return sum_s;
}

std::vector<Problem> study_problems() {
  std::vector<Problem> problems = {
      open_sky("long-arc", "one second in the air", {200.0, 400.0, 900.0, -900.0}, 1.0),
      open_sky("short-arc", "a fifth of a second in the air", {200.0, 400.0, 900.0, -900.0}, 0.2),
      open_sky("fast-arc", "one second at 10,000 px/s", {200.0, 6000.0, 8000.0, -6000.0}, 1.0),
      open_sky("terminal-speed", "one second at terminal speed",
               {200.0, 200.0, 0.0, Model{}.gravity_px_per_s2 / 0.0600300}, 1.0),
      on_desktop("fling", "a fling that bounces until it settles", {60.0, 900.0, 1000.0, -1350.0}, 8.0),
      on_desktop("corner-fling", "a fast fling into a corner", {300.0, 500.0, 2400.0, -700.0}, 8.0)};
  Problem jittered = problems[4];
  jittered.name = "jittered-fling";
  jittered.label = "the fling on a clock that jitters by half a frame";
  jittered.jitter = Jitter{Jitter::Kind::uniform, 0.5, 7};
  Problem hitched = problems[0];
  hitched.name = "hitched-arc";
  hitched.label = "the second in the air, a quarter of it one frame";
  const Bounds sky = hitched.stages[0].bounds;
  hitched.stages = {Stage{.duration_s = 0.4, .bounds = sky},
                    Stage{.duration_s = 0.6, .bounds = sky, .hitch_s = 0.25}};
  hitched.is_free_flight = false;
  problems.push_back(jittered);
  problems.push_back(hitched);
  return problems;
}

ScenarioProblem problem_of(const Scenario& scenario) {
  const std::int64_t steps = step_count(scenario);
  const std::vector<std::int64_t> frames = schedule_events(scenario, steps).frames;
  const FrameClock clock(scenario.clock);
  Problem problem;
  problem.name = scenario.name;
  problem.label = "scenario " + scenario.name;
  problem.start = start_state(scenario);
  World world{.state = {}, .window = scenario.window, .sprite = scenario.sprite};
  Stage stage;
  Timeline time;
  double stage_from_s = 0.0;
  const auto end_stage = [&] {
    stage.duration_s = time.time_s() - stage_from_s;
    if (stage.duration_s == 0.0) return;  // Its inputs belong to the next stage that lasts.
    stage.bounds = world.bounds();
    stage.is_held = world.is_held;
    problem.stages.push_back(std::exchange(stage, {}));
    stage_from_s = time.time_s();
  };
  std::size_t event = 0;
  for (std::int64_t frame = 0; frame < steps; ++frame) {
    double dt_s = clock.dt_s(frame);
    if (event < frames.size() && frames[event] == frame) end_stage();
    for (; event < frames.size() && frames[event] == frame; ++event) {
      const Action& action = scenario.events[event].action;
      stage.inputs.push_back(action);
      apply(action, world);
      if (const auto* hitch = std::get_if<Hitch>(&action)) {
        dt_s = hitch->dt_s;
        if (dt_s > 0.0) stage.hitch_s = dt_s;
      }
    }
    time.play(dt_s);
    if (time.time_s() > kProblemMax_s || frame == kFramesMax) {
      problem.remark = "its first " + std::to_string(time.time_s()) + " s";
      break;
    }
  }
  end_stage();
  if (problem.stages.empty()) return {std::nullopt, "no time passes in it"};
  if (std::any_of(problem.stages.begin(), problem.stages.end(), [](const Stage& each) {
        return each.bounds.right_px < 0.0 || each.bounds.bottom_px < 0.0;
      }))
    return {std::nullopt, "its window cannot hold its sprite, so that it has no exact solution"};
  if (problem.duration_s() > 2.0 * kProblemMax_s)
    return {std::nullopt, "a frame of it lasts longer than a study may"};
  if (scenario.clock.jitter && base_dt_s(scenario.clock) > 0.0)
    problem.jitter = per_frame(*scenario.clock.jitter, base_dt_s(scenario.clock));
  return {problem, ""};
}

std::vector<std::vector<double>> stage_frames_s(const Problem& problem, double rate_hz) {
  std::vector<std::vector<double>> stages;
  std::int64_t frame = 0;
  for (const Stage& stage : problem.stages) {
    std::vector<double> frames_s;
    double left_s = stage.duration_s;
    if (stage.hitch_s) {
      frames_s.push_back(std::min(*stage.hitch_s, left_s));
      left_s -= frames_s.back();
    }
    const double count = std::max(1.0, std::round(left_s * rate_hz));
    if (left_s > 0.0) {
      const double dt_s = left_s / count;
      const std::size_t end = frames_s.size() + static_cast<std::size_t>(count);
      for (; frames_s.size() < end; ++frame) {
        frames_s.push_back(problem.jitter ? jittered_dt_s(dt_s, of_frame(*problem.jitter, dt_s), frame)
                                          : dt_s);
      }
    }
    stages.push_back(std::move(frames_s));
  }
  return stages;
}

}  // namespace hyrax
