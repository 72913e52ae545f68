#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "tools/app/drift/drift.h"

namespace hyrax {
namespace {

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

HalfDt measure_half_dt(const Core& core, const Scenario& scenario) {
  constexpr std::int64_t kStepsMaxHere = 1'000'000;
  if (scenario.clock.jitter) return {.why_not = "jitter"};
  if (std::holds_alternative<RecordedSteps>(scenario.clock.base)) return {.why_not = "a trace"};
  const std::int64_t steps = step_count(scenario);
  if (steps == 0 || base_dt_s(scenario.clock) == 0.0) return {.why_not = "dt is 0"};
  if (steps > kStepsMaxHere) return {.why_not = "over 1e6 steps"};
  const std::optional<Scenario> halved = at_half_dt(scenario);
  if (!halved) return {.why_not = "no such clock"};
  return {.run = measure_drift(core, *halved)};
}

}  // namespace hyrax
