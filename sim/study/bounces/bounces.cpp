#include "sim/study/bounces/bounces.h"

#include <cmath>
#include <utility>

#include "sim/motion/step.h"
#include "sim/reference/exact_fling.h"
#include "sim/study/methods/many_flings.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

constexpr double kMinute_s = 60.0, kTenMinutes_s = 600.0;

State stepped_for(const Constants& laws, StepOrder order, State body, double rate_hz, double duration_s) {
  for (std::int64_t frame = std::llround(duration_s * rate_hz); frame > 0; --frame)
    body = stepped(laws, order, body, 1.0 / rate_hz, kDesktop);
  return body;
}

}  // namespace

Constants lossless(const Core& core) {
  return {.gravity_px_per_s2 = core.constants->gravity_px_per_s2,
          .restitution = 1.0,
          .air_drag = 1.0,
          .ground_friction = 1.0,
          .rest_threshold_px_per_s = 0.0};
}

double energy(const State& body, double gravity_px_per_s2, const Bounds& bounds) {
  return (body.vx_px_per_s * body.vx_px_per_s + body.vy_px_per_s * body.vy_px_per_s) / 2 +
         gravity_px_per_s2 * (bounds.bottom_px - body.y_px);
}

std::vector<KeptEnergy> kept_energies(const Core& core, std::int64_t throws) {
  const ManyFlings flings({FixedRate{60.0}, {}}, kTenMinutes_s, throws);
  const Constants laws = lossless(core);
  std::vector<KeptEnergy> kept;
  const auto add = [&](BounceMethod method, double rate_hz, const auto& play) {
    for (std::int64_t number = 0; number < throws; ++number) {
      const State start = flings.start(number);
      const auto [minute, ten_minutes] = play(start);
      const auto energy_of = [&](const State& body) {
        return energy(body, laws.gravity_px_per_s2, kDesktop);
      };
      kept.push_back({method, rate_hz, number, std::hypot(start.vx_px_per_s, start.vy_px_per_s),
                      energy_of(minute) / energy_of(start), energy_of(ten_minutes) / energy_of(start)});
    }
  };
  for (const auto& [method, order] : {std::pair(BounceMethod::paper, StepOrder::paper),
                                      std::pair(BounceMethod::explicit_euler, StepOrder::position_first)})
    for (const double rate_hz : {24.0, 60.0, 144.0, 240.0})
      add(method, rate_hz, [&, order = order](const State& start) {
        const State minute = stepped_for(laws, order, start, rate_hz, kMinute_s);
        return std::pair(minute, stepped_for(laws, order, minute, rate_hz, kTenMinutes_s - kMinute_s));
      });
  ExactFling exact{FixedLaws(Model(laws))};
  add(BounceMethod::exact, 0.0, [&](const State& start) {
    exact.start(start, kDesktop);
    const State minute = exact.at(kMinute_s);
    return std::pair(minute, exact.at(kTenMinutes_s));
  });
  return kept;
}

}  // namespace hyrax
