#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "tools/app/drift/drift.h"

namespace hyrax {
namespace {

// Prevents the compiler from removing the work that made `body`.
void keep(const State& state) { asm volatile("" : : "r"(&state) : "memory"); }

std::vector<double> first_frames_s(const Scenario& scenario) {
  constexpr std::int64_t kFramesMax = 1000;
  const FrameClock clock(scenario.clock);
  std::vector<double> frames_s;
  for (std::int64_t frame = 0; frame < std::min(step_count(scenario), kFramesMax); ++frame)
    frames_s.push_back(clock.dt_s(frame));
  return frames_s;
}

void play(const Core& core, const Scenario& scenario, const std::vector<double>& frames_s, int times) {
  const Bounds bounds = bounds_of(scenario.window, scenario.sprite);
  for (int time = 0; time < times; ++time) keep(core.played(start_state(scenario), frames_s, bounds));
}

// Twice the frames, and twice the frame numbers of events; a hitch keeps its dt.
std::optional<Scenario> at_half_dt(Scenario scenario) {
  const std::int64_t steps = step_count(scenario);
  const std::vector<std::int64_t> frames = schedule_events(scenario, steps).frames;
  if (auto* rate = std::get_if<FixedRate>(&scenario.clock.base)) {
    rate->rate_hz *= 2.0;
    if (rate->rate_hz > kRateMax_hz) return std::nullopt;
  } else {
    std::get<FixedStep>(scenario.clock.base).dt_s *= 0.5;
  }
  scenario.length = 2 * steps;
  for (std::size_t event = 0; event < frames.size(); ++event) scenario.events[event].when = 2 * frames[event];
  return scenario;
}

}  // namespace

std::optional<double> step_ns(const Core& core, const Scenario& scenario) {
  const std::vector<double> frames_s = first_frames_s(scenario);
  if (frames_s.empty()) return std::nullopt;
  constexpr std::size_t kStepsPerRound = 100'000;
  constexpr int kRounds = 7;
  const int times = static_cast<int>(kStepsPerRound / frames_s.size());
  double least_ns = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    play(core, scenario, frames_s, times);
    const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
    least_ns = std::min(least_ns, elapsed.count());
  }
  return least_ns / static_cast<double>(times) / static_cast<double>(frames_s.size());
}

HalfDt measure_half_dt(const Core& core, const Scenario& scenario) {
  constexpr std::int64_t kStepsMaxHere = 1'000'000;
  if (scenario.clock.jitter) return {.why_not = "jitter"};
  if (std::holds_alternative<RecordedSteps>(scenario.clock.base)) return {.why_not = "a trace"};
  const std::int64_t steps = step_count(scenario);
  if (steps == 0 || base_dt_s(scenario.clock) == 0.0) return {.why_not = "dt is 0"};
  if (steps > kStepsMaxHere) return {.why_not = "over 1e6 steps"};
  const std::optional<Scenario> halved = at_half_dt(scenario);
  if (!halved) return {.why_not = "no such clock"};
  return {.run = measure_drift(core, *halved), .step_ns = step_ns(core, *halved).value_or(0.0)};
}

}  // namespace hyrax
