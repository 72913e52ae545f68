// Frame times and inputs that are wrong on purpose. The linker passes each call from another source file
// through these (--wrap).

#include <algorithm>
#include <cstring>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "tests/must_fail/altered_cores/altered_core.h"

// The function of that symbol, and what other source files call in its place.
#define WRAPPED(symbol, result, name, ...)                   \
  result original_##name(__VA_ARGS__) asm("__real_" symbol); \
  result altered_##name(__VA_ARGS__) asm("__wrap_" symbol);

namespace hyrax {

WRAPPED("_ZN5hyrax10FrameClockC1ERKNS_5ClockE", void, clock, FrameClock*, const Clock&)
WRAPPED("_ZN5hyrax13jittered_dt_sEdRKNS_6JitterEl", double, jitter, double, const Jitter&, std::int64_t)
WRAPPED("_ZN5hyrax15schedule_eventsERKNS_8ScenarioEll", Schedule, schedule, const Scenario&, std::int64_t,
        std::int64_t)
WRAPPED("_ZN5hyrax9inputs_ofERKNS_8ScenarioEl", std::vector<Input>, inputs, const Scenario&, std::int64_t)

namespace {

// The jitter of a clock that has none.
constexpr Jitter kFirstFrame;

// No later than the last frame. Inputs stay in their order.
std::int64_t late(std::int64_t frame, std::int64_t steps, bool is_last) {
  const AlteredStep& step = altered_step();
  const std::int64_t frames = step.inputs_late + (is_last ? step.last_input_late : 0);
  return frame >= 0 && frame < steps ? std::min(frame + frames, steps - 1) : frame;
}

}  // namespace

// The base dt is the first member, the jitter the second.
void altered_clock(FrameClock* made, const Clock& clock) {
  original_clock(made, clock);
  double base_dt_s = 0.0;
  std::memcpy(&base_dt_s, made, sizeof base_dt_s);
  base_dt_s *= altered_step().frame_factor;
  std::memcpy(static_cast<void*>(made), &base_dt_s, sizeof base_dt_s);
  if (altered_step().first_frame_factor == 1.0 || !made->is_fixed()) return;
  const Jitter* const jitter = &kFirstFrame;
  std::memcpy(reinterpret_cast<std::byte*>(made) + sizeof base_dt_s, &jitter, sizeof jitter);
}

double altered_jitter(double dt_s, const Jitter& jitter, std::int64_t frame) {
  const AlteredStep& step = altered_step();
  if (&jitter == &kFirstFrame) return frame == 0 ? dt_s * step.first_frame_factor : dt_s;
  const double factor = frame == 0 ? step.first_jitter_factor : 1.0;
  return original_jitter(dt_s, jitter, frame + step.jitter_shift) * step.jitter_factor * factor;
}

Schedule altered_schedule(const Scenario& scenario, std::int64_t steps, std::int64_t walked_frame_max) {
  Schedule schedule = original_schedule(scenario, steps, walked_frame_max);
  for (std::int64_t& frame : schedule.frames) frame = late(frame, steps, &frame == &schedule.frames.back());
  return schedule;
}

std::vector<Input> altered_inputs(const Scenario& scenario, std::int64_t frames) {
  std::vector<Input> inputs = original_inputs(scenario, frames);
  for (Input& input : inputs) input.frame = late(input.frame, step_count(scenario), &input == &inputs.back());
  return inputs;
}

}  // namespace hyrax
