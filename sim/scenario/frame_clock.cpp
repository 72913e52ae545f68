#include "sim/scenario/frame_clock.h"

#include <algorithm>
#include <cmath>

#include "sim/scenario/split_mix64.h"

namespace hyrax {

double base_dt_s(const Clock& clock) {
  assert(!std::holds_alternative<RecordedSteps>(clock.base));
  if (const auto* rate = std::get_if<FixedRate>(&clock.base)) return 1.0 / rate->rate_hz;
  return std::get<FixedStep>(clock.base).dt_s;
}

double jittered_dt_s(double dt_s, const Jitter& jitter, std::int64_t frame) {
  const auto index = static_cast<std::uint64_t>(frame);
  const auto draw = [&](std::uint64_t k) { return split_mix64_unit(jitter.seed, k); };
  double jittered_s = dt_s;
  switch (jitter.kind) {
    case Jitter::Kind::uniform:
      jittered_s = dt_s * (1.0 + jitter.amount * (2.0 * draw(index) - 1.0));
      break;
    case Jitter::Kind::normal: {  // Irwin-Hall: the sum of twelve uniform draws has mean 6 and variance 1.
      double sum = 0.0;
      for (std::uint64_t k = 0; k < 12; ++k) sum += draw(12 * index + k);
      jittered_s = dt_s + jitter.amount * (sum - 6.0);
      if (jittered_s <= 0.0) jittered_s = 0.0;
      break;
    }
    case Jitter::Kind::missed_frames:
      if (draw(index) < jitter.amount) jittered_s = dt_s * 2.0;
      break;
  }
  return jittered_s > kFrameMax_s ? kFrameMax_s : jittered_s;
}

double longest_dt_s(const Clock& clock) {
  const double dt_s = base_dt_s(clock);
  if (!clock.jitter) return dt_s;
  double longest_s = 2.0 * dt_s;  // Of missed_frames, and of uniform with a fraction of 1.
  if (clock.jitter->kind == Jitter::Kind::normal) longest_s = dt_s + 6.0 * clock.jitter->amount;
  return std::min(longest_s, kFrameMax_s);
}

std::int64_t step_count(const ScenarioHead& scenario) {
  if (const auto* trace = std::get_if<RecordedSteps>(&scenario.clock.base))
    return static_cast<std::int64_t>(trace->dt_s.size());
  if (const auto* steps = std::get_if<std::int64_t>(&scenario.length)) return *steps;
  assert(base_dt_s(scenario.clock) > 0.0);
  const double frames = std::ceil(std::get<double>(scenario.length) / base_dt_s(scenario.clock) - 1e-9);
  if (!(frames <= static_cast<double>(kStepsMax))) return kStepsMax + 1;
  return static_cast<std::int64_t>(frames);
}

FrameClock::FrameClock(const Clock& clock) {
  if (const auto* trace = std::get_if<RecordedSteps>(&clock.base)) {
    trace_ = &trace->dt_s;
    return;
  }
  base_dt_s_ = hyrax::base_dt_s(clock);
  if (clock.jitter) jitter_ = &*clock.jitter;
}

}  // namespace hyrax
