#include "sim/study/paper/claim_probe.h"

#include <fmt/format.h>

#include "sim/motion/step.h"
#include "sim/result/estimate.h"

namespace hyrax {

std::string digits(double value) { return fmt::format("{:.4g}", value); }

State random_throw(const ClaimStarts& starts, std::uint64_t start) {
  const auto random = [&](std::uint64_t which, double low, double high) {
    return random_between(starts.seed, 4 * start + which, low, high);
  };
  const double fastest = starts.fastest_px_per_s;
  return {random(0, 0.0, kDesktop.right_px), random(1, 0.0, kDesktop.bottom_px), random(2, -fastest, fastest),
          random(3, -fastest, fastest)};
}

Finding finding_of(const std::vector<double>& values, ClaimVerdict verdict, std::string remark) {
  return {
      quantile(values, 0.5), verdict, std::move(remark), {{quantile(values, 0.1), quantile(values, 0.9)}}};
}

std::int64_t steps_that_differ_from_listing(const Core& core, std::int64_t steps) {
  constexpr std::int64_t kStepsOfAFling = 500;
  constexpr std::int64_t kStepsInACorner = 25;
  const auto corner_speed = [](std::int64_t step) {
    return 500.0 + 2000.0 * split_mix64_unit(815, static_cast<std::uint64_t>(step));
  };
  const Constants constants = core.constants.value();
  std::int64_t differing = 0;
  State body;
  for (std::int64_t step = 0; step < steps; ++step) {
    if (step % kStepsOfAFling == 0) {
      const auto first = 4 * static_cast<std::uint64_t>(step);
      const auto random = [first](std::uint64_t which) { return split_mix64_unit(4711, first + which); };
      body = {kDesktop.right_px * random(0), kDesktop.bottom_px * random(1), 6000.0 * (random(2) - 0.5),
              6000.0 * (random(3) - 0.5)};
    }
    // Every other fling is thrown into corners, so that both walls act in one step.
    if (step / kStepsOfAFling % 2 == 1 && step % kStepsInACorner == 1) {
      const double side = step % (2 * kStepsInACorner) == 1 ? 1.0 : 0.0;
      body = {side * kDesktop.right_px, kDesktop.bottom_px, (2.0 * side - 1.0) * corner_speed(step),
              corner_speed(step)};
    }
    // Some frames have zero length: a sprite on a bound has then not passed it.
    const double random_dt_s = 0.03 * split_mix64_unit(1147, static_cast<std::uint64_t>(step));
    const double dt_s = step % 7 == 0 ? 0.0 : random_dt_s;
    const State next = core.step(body, dt_s, kDesktop);
    if (!same_bits(next, stepped(constants, StepOrder::paper, body, dt_s, kDesktop))) ++differing;
    body = next;
  }
  return differing;
}

}  // namespace hyrax
