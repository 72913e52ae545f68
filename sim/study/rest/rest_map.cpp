#include "sim/study/rest/rest_map.h"

#include <cmath>

#include "sim/reference/flight.h"
#include "sim/study/methods/many_flings.h"

namespace hyrax {
namespace {

double gain_px_per_s(const Core& core, double rate_hz) {
  const Constants constants = core.constants.value();
  return constants.air_drag * constants.gravity_px_per_s2 / rate_hz;
}

double residual_px_per_s(const Core& core, double rate_hz) {
  const Constants constants = core.constants.value();
  return -constants.restitution * gain_px_per_s(core, rate_hz) /
         (1.0 + constants.air_drag * constants.restitution);
}

bool is_near(double a, double b) { return std::fabs(a - b) <= 1e-6 * std::fabs(b); }

// On the floor at this speed, `steps` later.
std::array<double, 2> speeds_after(const Core& core, double vy_px_per_s, double rate_hz, std::int64_t steps) {
  const double dt_s = 1.0 / rate_hz;
  const State row = core.steps({900.0, kDesktop.bottom_px, 0.0, vy_px_per_s}, dt_s, kDesktop, steps);
  return {row.vy_px_per_s, core.step(row, dt_s, kDesktop).vy_px_per_s};
}

bool stays_at_zero(const Core& core, double rate_hz) {
  const auto [first, second] = speeds_after(core, 0.0, rate_hz, 2);
  return first == 0.0 && second == 0.0;
}
bool keeps_residual_speed(const Core& core, double rate_hz) {
  const auto [first, second] = speeds_after(core, residual_px_per_s(core, rate_hz), rate_hz, 1000);
  return first != 0.0 && second != 0.0;
}
bool returns_to_zero(const Core& core, double rate_hz) {
  const auto [first, second] = speeds_after(core, 0.0, rate_hz, 1000);
  return first == 0.0 || second == 0.0;
}

// The rate at which `holds` changes, by bisection between 1 and 100,000 Hz.
template <class Holds>
std::optional<double> changes_at(const Core& core, const Holds& holds) {
  double low_hz = 1.0, high_hz = 1e5;
  const bool at_low = holds(core, low_hz);
  if (at_low == holds(core, high_hz)) return std::nullopt;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle_hz = 0.5 * (low_hz + high_hz);
    (holds(core, middle_hz) == at_low ? low_hz : high_hz) = middle_hz;
  }
  return high_hz;
}

// Whether the boundaries allow this state at this rate; next to a boundary rounding decides, and any is
// allowed.
bool is_allowed(FinalState state, double rate_hz, const std::vector<RestBoundary>& boundaries) {
  for (const RestBoundary& boundary : boundaries)
    if (std::fabs(rate_hz / boundary.analytic_hz - 1.0) < 1e-6) return state != FinalState::moving;
  if (rate_hz > boundaries[0].analytic_hz) return state == FinalState::zero_speed;
  if (rate_hz > boundaries[1].analytic_hz) return state == FinalState::two_cycle;
  if (rate_hz > boundaries[2].analytic_hz)
    return state == FinalState::two_cycle || state == FinalState::residual_speed;
  return state == FinalState::residual_speed;
}

RateEnds ends_at(const Core& core, double rate_hz, std::int64_t flings,
                 const std::vector<RestBoundary>& boundaries) {
  RateEnds ends{.rate_hz = rate_hz, .gain_px_per_s = gain_px_per_s(core, rate_hz)};
  std::vector<double> times_s;
  for (const MemberResult& end : ManyFlings({FixedRate{rate_hz}, {}}, kRestPlayed_s, flings).play(core)) {
    const bool has_settled = !std::isnan(end.at_rest_since_s);
    const State next = core.step(end.final, 1.0 / rate_hz, kDesktop);
    const FinalState state = has_settled ? final_state(core, end.final, next, rate_hz) : FinalState::moving;
    ++ends.flings[static_cast<std::size_t>(state)];
    if (has_settled && !is_allowed(state, rate_hz, boundaries)) ++ends.unforeseen;
    if (has_settled) times_s.push_back(end.at_rest_since_s);
  }
  ends.settles_s = band_of(times_s);
  return ends;
}

}  // namespace

bool RestBoundary::agrees() const {
  return measured_hz.has_value() && std::fabs(*measured_hz / analytic_hz - 1.0) < 1e-9;
}

std::vector<RestBoundary> rest_boundaries(const Core& core) {
  const Constants constants = core.constants.value();
  const double kept = constants.air_drag * constants.restitution;
  // The rate at which one step of gravity adds `gain`.
  const auto rate_of = [&constants](double gain) {
    return constants.air_drag * constants.gravity_px_per_s2 / gain;
  };
  const double threshold = constants.rest_threshold_px_per_s / constants.restitution;
  return {{"rest above, cycle below", "zero speed above, two-cycle below", rate_of(threshold),
           changes_at(core, stays_at_zero)},
          {"buzz possible below", "residual speed possible below", rate_of(threshold * (1.0 + kept)),
           changes_at(core, keeps_residual_speed)},
          {"cycle possible above", "two-cycle possible above", rate_of(threshold / (1.0 - kept)),
           changes_at(core, returns_to_zero)}};
}

FinalState final_state(const Core& core, const State& row, const State& next, double rate_hz) {
  if (row.y_px != kDesktop.bottom_px || next.y_px != kDesktop.bottom_px) return FinalState::moving;
  const double a = row.vy_px_per_s, b = next.vy_px_per_s;
  if (a == 0.0 && b == 0.0) return FinalState::zero_speed;
  const double thrown_px_per_s = -core.constants->restitution * gain_px_per_s(core, rate_hz);
  if ((a == 0.0 && is_near(b, thrown_px_per_s)) || (b == 0.0 && is_near(a, thrown_px_per_s)))
    return FinalState::two_cycle;
  const double residual = residual_px_per_s(core, rate_hz);
  return is_near(a, residual) && is_near(b, residual) ? FinalState::residual_speed : FinalState::moving;
}

std::vector<RateEnds> rest_map(const Core& core, const std::vector<double>& rates_hz, std::int64_t flings) {
  const std::vector<RestBoundary> boundaries = rest_boundaries(core);
  std::vector<RateEnds> map;
  map.reserve(rates_hz.size());
  for (const double rate_hz : rates_hz) map.push_back(ends_at(core, rate_hz, flings, boundaries));
  return map;
}

std::vector<DropBounce> bounces_at(const Core& core, double rate_hz, std::int64_t phases) {
  constexpr double kHeight_px = 600.0;
  const Constants constants = core.constants.value();
  const double dt_s = 1.0 / rate_hz;
  const double last_way_px = std::sqrt(2.0 * constants.gravity_px_per_s2 * kHeight_px) * dt_s;
  std::vector<DropBounce> bounces;
  for (std::int64_t phase = 0; phase < phases; ++phase) {
    const double height_px =
        kHeight_px + last_way_px * static_cast<double>(phase) / static_cast<double>(phases);
    const std::optional<Impact> impact =
        time_of_impact({.position_px = -height_px,
                        .speed_px_per_s = 0.0,
                        .acceleration_px_per_s2 = constants.gravity_px_per_s2,
                        .drag_rate_per_s = -std::log(constants.air_drag) * rate_hz},
                       60.0);
    State body{900.0, kDesktop.bottom_px - height_px, 0.0, 0.0};
    for (std::int64_t step = 0; step < static_cast<std::int64_t>(kRestPlayed_s * rate_hz); ++step) {
      const State flight = core.flight(body, dt_s);
      body = core.step(body, dt_s, kDesktop);
      if (!(flight.y_px > kDesktop.bottom_px)) continue;
      if (impact && impact->speed_px_per_s > 0.0)
        bounces.push_back({rate_hz, (flight.y_px - kDesktop.bottom_px) / (flight.vy_px_per_s * dt_s),
                           -body.vy_px_per_s / impact->speed_px_per_s});
      break;
    }
  }
  return bounces;
}

}  // namespace hyrax
