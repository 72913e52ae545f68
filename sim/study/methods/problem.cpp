#include "sim/study/methods/problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "sim/reference/flight.h"
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

constexpr Size kSky{1'000'000, 1'000'000};

// Coordinates stay as small as the flight allows, so that rounding does: upwards it turns below the top.
Problem open_sky(const std::string& name, const std::string& label, const Velocity& velocity,
                 double duration_s, const FixedLaws& laws) {
  const double up_px_per_s = -velocity.vy_px_per_s;
  const double rise_px =
      up_px_per_s <= 0.0
          ? 200.0
          : std::min(up_px_per_s * up_px_per_s / (2.0 * laws.gravity_px_per_s2), up_px_per_s * duration_s);
  Problem problem = on_desktop(
      name, label, {200.0, 100.0 * std::ceil(rise_px / 100.0), velocity.vx_px_per_s, velocity.vy_px_per_s},
      duration_s, kSky);
  problem.is_free_flight = true;
  return problem;
}

// A fling that is played for 8 s, and for longer if the exact one then needs it until it lies, and slides by
// less than half a pixel more.
Problem until_settled(const std::string& name, const std::string& label, const State& start,
                      const FixedLaws& laws) {
  constexpr double kLeast_s = 8.0;
  Problem problem = on_desktop(name, label, start, kLeast_s);
  double& until_s = problem.stages.front().duration_s;
  ExactFling fling(laws);
  fling.start(start, problem.stages.front().bounds, false, kProblemMax_s);
  const auto has_settled = [&] {
    const double vx_px_per_s = fling.at(until_s).vx_px_per_s;
    return fling.slides() &&
           std::fabs(vx_px_per_s) <= 0.5 * (laws.drag_rate_per_s + laws.friction_rate_per_s);
  };
  while (!has_settled() && until_s < kProblemMax_s) ++until_s;
  if (!has_settled()) {
    until_s = kLeast_s;
    problem.remark = fmt::format("its first {:g} s: it does not settle in {:g} s", kLeast_s, kProblemMax_s);
  }
  return problem;
}

// Thrown so that by the exact laws it meets both walls of the lower right corner at one time.
State into_corner(const FixedLaws& laws) {
  const Bounds bounds = bounds_of(kScreen, kSprite);
  State start{300.0, 500.0, 0.0, 0.0};
  const double k = laws.drag_rate_per_s, way_px = bounds.right_px - start.x_px;
  start.vx_px_per_s = std::max(2400.0, 2.0 * k * way_px);
  const double t_s = k > 0.0 ? -std::log1p(-k * way_px / start.vx_px_per_s) / k : way_px / start.vx_px_per_s;
  start.vy_px_per_s =
      (bounds.bottom_px - start.y_px - fly(0.0, laws.gravity_px_per_s2, k, t_s).displacement_px) /
      fly(1.0, 0.0, k, t_s).displacement_px;
  return start;
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

std::vector<Problem> study_problems(const FixedLaws& laws) {
  std::vector<Problem> problems = {
      open_sky("long-arc", "one second in the air", {900.0, -900.0}, 1.0, laws),
      open_sky("short-arc", "a fifth of a second in the air", {900.0, -900.0}, 0.2, laws),
      open_sky("fast-arc", "one second at 10,000 px/s", {8000.0, -6000.0}, 1.0, laws),
      until_settled("fling", "a fling that bounces until it settles", {60.0, 900.0, 1000.0, -1350.0}, laws),
      until_settled("corner-fling", "a fast fling into a corner", into_corner(laws), laws)};
  Problem jittered = problems[3];
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
  const double terminal_px_per_s = laws.gravity_px_per_s2 / laws.drag_rate_per_s;
  if (terminal_px_per_s < 0.9 * kSky.height_px)  // Else it has no room for it, or there is no such speed.
    problems.push_back(
        open_sky("terminal-speed", "one second at terminal speed", {0.0, terminal_px_per_s}, 1.0, laws));
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
