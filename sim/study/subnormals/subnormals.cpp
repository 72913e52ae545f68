#include "sim/study/subnormals/subnormals.h"

#include <cmath>
#include <limits>

#include "sim/replay/core.h"
#include "sim/replay/core_constants.h"
#include "sim/replay/replay.h"

namespace hyrax {
namespace {

constexpr Size kWindow{1920, 1080}, kHyrax{128, 128};
constexpr double kUnit = std::numeric_limits<double>::denorm_min();

bool is_subnormal(double value) { return std::fpclassify(value) == FP_SUBNORMAL; }

State on_floor(double vx_px_per_s) { return {700.0, bounds_of(kWindow, kHyrax).bottom_px, vx_px_per_s, 0.0}; }

// A clock without equal frames, so that no repetition is found and every frame is played.
Scenario long_rest(double vx_px_per_s, std::int64_t steps) {
  Scenario scenario;
  scenario.window = kWindow;
  scenario.sprite = kHyrax;
  const State start = on_floor(vx_px_per_s);
  scenario.start = {start.x_px, start.y_px};
  scenario.start_velocity = {vx_px_per_s, 0.0};
  scenario.clock.base = FixedRate{60.0};
  scenario.clock.jitter = Jitter{Jitter::Kind::normal, 0.001, 1};
  scenario.length = steps;
  return scenario;
}

}  // namespace

SlideEnd slide_end(double rate_hz) {
  constexpr std::int64_t kStepsPlayed = 8'000, kDrawnEvery = 16;
  const Bounds bounds = bounds_of(kWindow, kHyrax);
  SlideEnd end{};
  end.rate_hz = rate_hz;
  State body{100.0, 100.0, 900.0, -1200.0};
  double x_px = 0.0;
  for (std::int64_t step = 1; step <= kStepsPlayed; ++step) {
    const double vx_before = body.vx_px_per_s;
    body = core_step(body, 1.0 / rate_hz, bounds);
    if (end.subnormal_step < 0 && is_subnormal(body.vx_px_per_s)) {
      end.subnormal_step = step;
      x_px = body.x_px;
    }
    if (end.subnormal_step >= 0) end.moved_px += std::fabs(body.x_px - x_px);
    x_px = body.x_px;
    if (!same_bits(body.vx_px_per_s, vx_before))
      end.stuck_step = -1;
    else if (end.stuck_step < 0)
      end.stuck_step = step - 1;
    if (end.stuck_step < 0 && step % kDrawnEvery == 0) {
      end.t_s.push_back(static_cast<double>(step) / rate_hz);
      end.exponent.push_back(std::log10(std::fabs(body.vx_px_per_s)));
    }
  }
  end.stuck_vx_px_per_s = body.vx_px_per_s;
  return end;
}

double largest_stuck_vx_px_per_s() {
  const Constants core = core_constants();
  const auto keeps = [](double units, double factor) { return std::nearbyint(units * factor) == units; };
  double units = 0.0;
  while (units < 1e6 && keeps(units + 1.0, core.air_drag) && keeps(units + 1.0, core.ground_friction))
    units += 1.0;
  return units * kUnit;
}

SlideCosts measure_slide_costs(const NanosecondClock& now_ns, bool is_quick) {
  constexpr std::int64_t kCoreSteps = 1'000, kReplaySteps = 8'192;
  struct Speed {
    const char* text;
    double vx_px_per_s;
  };
  // From 1e-50, 1000 steps on the floor end at 1e-148.
  const Speed speeds[] = {
      {"vx = 0", 0.0}, {"vx shrinks, above 1e-308", 1e-50}, {"vx is stuck at 1e-323", 2.0 * kUnit}};
  SlideCosts measured;
  std::vector<Scenario> rests;
  for (const Speed& speed : {speeds[0], speeds[2]})
    rests.push_back(long_rest(speed.vx_px_per_s, kReplaySteps));
  std::vector<std::function<void()>> works;
  volatile double result = 0.0;
  for (const Speed& speed : speeds) {
    measured.costs.push_back({"physics::update", speed.text, {}, {}});
    works.emplace_back([&result, body = on_floor(speed.vx_px_per_s)] {
      result = core_steps(body, 1.0 / 60.0, bounds_of(kWindow, kHyrax), kCoreSteps).y_px;
    });
  }
  for (const Scenario& rest : rests) {
    measured.costs.push_back({"run, jittered frames", speeds[&rest == &rests[0] ? 0 : 2].text, {}, {}});
    works.emplace_back([&result, &rest] {
      RowSink nothing;
      result = replay(rest, nothing).final.y_px;
    });
  }
  const Costs costs = measure_costs(works, now_ns, {.repetitions = is_quick ? 20 : 60, .sample_ns = 200'000});
  measured.probe = costs.probe;
  for (std::size_t index = 0; index < works.size(); ++index) {
    const bool is_core = index < std::size(speeds);
    const double steps = static_cast<double>(is_core ? kCoreSteps : kReplaySteps);
    const Cost& cost = costs.costs[index];
    SlideCost& line = measured.costs[index];
    line.step_ns = {cost.time_ns.median / steps, cost.time_ns.low / steps, cost.time_ns.high / steps};
    line.ratio = ratio_of(cost, costs.costs[is_core ? 0 : std::size(speeds)]);
  }
  return measured;
}

}  // namespace hyrax
