// Frame times and inputs that are wrong on purpose. The linker passes each call from another source file
// through these (--wrap): what is fed to the step is altered, the step is not.
#include <algorithm>
#include <cstring>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "tests/must_fail/altered_cores/altered_core.h"

#define WRAPPED(symbol) asm("__wrap_" symbol)
#define ORIGINAL(symbol) asm("__real_" symbol)

namespace hyrax {

void original_clock(FrameClock* made, const Clock& clock) ORIGINAL("_ZN5hyrax10FrameClockC1ERKNS_5ClockE");
void altered_clock(FrameClock* made, const Clock& clock) WRAPPED("_ZN5hyrax10FrameClockC1ERKNS_5ClockE");
// The base dt is the first member.
void altered_clock(FrameClock* made, const Clock& clock) {
  original_clock(made, clock);
  double base_dt_s = 0.0;
  std::memcpy(&base_dt_s, made, sizeof base_dt_s);
  base_dt_s *= altered_step().frame_factor;
  std::memcpy(static_cast<void*>(made), &base_dt_s, sizeof base_dt_s);
}

double original_jitter(double dt_s, const Jitter& jitter, std::int64_t frame)
    ORIGINAL("_ZN5hyrax13jittered_dt_sEdRKNS_6JitterEl");
double altered_jitter(double dt_s, const Jitter& jitter, std::int64_t frame)
    WRAPPED("_ZN5hyrax13jittered_dt_sEdRKNS_6JitterEl");
double altered_jitter(double dt_s, const Jitter& jitter, std::int64_t frame) {
  return original_jitter(dt_s, jitter, frame) * altered_step().jitter_factor;
}

namespace {

// No later than the last frame. Inputs stay in their order.
std::int64_t late(std::int64_t frame, std::int64_t steps) {
  return frame >= 0 && frame < steps ? std::min(frame + altered_step().inputs_late, steps - 1) : frame;
}

}  // namespace

Schedule original_schedule(const Scenario& scenario, std::int64_t steps, std::int64_t walked_frame_max)
    ORIGINAL("_ZN5hyrax15schedule_eventsERKNS_8ScenarioEll");
Schedule altered_schedule(const Scenario& scenario, std::int64_t steps, std::int64_t walked_frame_max)
    WRAPPED("_ZN5hyrax15schedule_eventsERKNS_8ScenarioEll");
Schedule altered_schedule(const Scenario& scenario, std::int64_t steps, std::int64_t walked_frame_max) {
  Schedule schedule = original_schedule(scenario, steps, walked_frame_max);
  for (std::int64_t& frame : schedule.frames) frame = late(frame, steps);
  return schedule;
}

std::vector<Input> original_inputs(const Scenario& scenario, std::int64_t frames)
    ORIGINAL("_ZN5hyrax9inputs_ofERKNS_8ScenarioEl");
std::vector<Input> altered_inputs(const Scenario& scenario, std::int64_t frames)
    WRAPPED("_ZN5hyrax9inputs_ofERKNS_8ScenarioEl");
std::vector<Input> altered_inputs(const Scenario& scenario, std::int64_t frames) {
  std::vector<Input> inputs = original_inputs(scenario, frames);
  for (Input& input : inputs) input.frame = late(input.frame, step_count(scenario));
  return inputs;
}

}  // namespace hyrax
