// The yardstick of speed: physics::update out of line, one call a step, state in memory.
#pragma once

#include "sim/motion/state.h"
#include "sim/physics/physics.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/split_mix64.h"
#include "tests/benchmarks/stopwatch.h"

namespace hyrax::bench {

inline constexpr double kDt_s = 1.0 / 60.0;
inline constexpr int kSprite_px = 128;
inline constexpr Size kDesktop{1920, 1080};

[[nodiscard]] inline physics body_at(const State& start) {
  return {start.x_px, start.y_px, start.vx_px_per_s, start.vy_px_per_s};
}

/// One of the throws that figures play: anywhere on the desktop, up to 2,000 px/s along x and y.
[[nodiscard]] inline State random_throw(std::size_t index) {
  const auto draw = [index](std::size_t place, double low, double high) {
    return low + (high - low) * split_mix64_unit(2026, 4 * index + place);
  };
  return {draw(0, 0, 1792), draw(1, 0, 952), draw(2, -2000, 2000), draw(3, -2000, 2000)};
}

void naive_step(physics& body, double dt_s, Size window);

/// So many steps at 60 Hz.
inline void step_naively(const State& start, std::int64_t steps, Size window = kDesktop) {
  physics body = body_at(start);
  for (std::int64_t step = 0; step < steps; ++step) naive_step(body, kDt_s, window);
  keep(body);
}

inline void step_all_naively(const std::vector<State>& starts, std::int64_t steps) {
  for (const State& start : starts) step_naively(start, steps);
}

/// A fling on the desktop at 60 Hz.
[[nodiscard]] inline Scenario desktop_fling(const State& start, std::int64_t steps) {
  return scenario_from(start, kDesktop, {kSprite_px, kSprite_px}, 60.0, steps);
}

}  // namespace hyrax::bench
