// Sections 2.3, 2.4 and 4.1: oscillators, order, energy drift and missed collisions, each over many starts.
#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "sim/core/core.h"
#include "sim/motion/step.h"
#include "sim/reference/arc_solution.h"
#include "sim/reference/exact_fling.h"
#include "sim/result/estimate.h"
#include "sim/study/paper/claim_probe.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

double median(const std::vector<double>& values) { return quantile(values, 0.5); }

// Nothing where the exact motion has no closed form.
std::optional<Model> model_of_core(const Core& core) {
  const Constants constants = core.constants.value();
  const bool is_solved =
      constants.gravity_px_per_s2 > 0.0 && constants.air_drag >= 0.5 && constants.air_drag <= 1.0;
  if (!is_solved) return std::nullopt;
  return Model(constants);
}
constexpr char kNotSolved[] = "the exact motion is solved for gravity above 0 and a drag factor of 0.5 to 1";

struct Swing {
  double y = 0.0;
  double v = 0.0;
};

// Moves a spring, v' = -w^2 y, by a step that knows gravity alone. Lengths are given to the step in units in
// which gravity is as strong as the spring is at y: 1 becomes `scale` px. Every operation of the step
// multiplies or adds lengths, so that a result divided by `scale` is that of the spring.
template <class Fly>
void swing_on(const Core& core, Swing& swing, double stiffness_per_s2, const Fly& fly) {
  constexpr double kLeast = 1e-6;
  const double y = std::copysign(std::max(std::fabs(swing.y), kLeast), swing.y);
  const double scale = core.constants->gravity_px_per_s2 / (-stiffness_per_s2 * y);
  const State moved = fly(State{0.0, 0.0, 0.0, swing.v * scale});
  swing = {swing.y + moved.y_px / scale, moved.vy_px_per_s / scale};
}

// Largest amplitude of the last hundred of 500 steps over that of the first hundred, without what drag takes.
template <class Fly>
double growth(const Core& core, double angle_rad, double phase_rad, const Fly& fly) {
  constexpr int kSteps = 500, kWindow = 100;
  const double w_per_s = angle_rad / kSixtieth_s;
  Swing swing{std::cos(phase_rad), w_per_s * std::sin(phase_rad)};
  double early = 0.0, late = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    swing_on(core, swing, w_per_s * w_per_s, fly);
    const double amplitude = std::hypot(swing.y, swing.v / w_per_s);
    if (step < kWindow) early = std::max(early, amplitude);
    if (step >= kSteps - kWindow) late = std::max(late, amplitude);
  }
  return late / early / std::pow(core.constants->air_drag, 0.5 * (kSteps - kWindow));
}

// The spring pulls where the core's step has gravity, and the position moves as the core moves it. Along the
// step's map areas grow by the determinant: drag alone for symplectic Euler, drag + (w dt)^2 for explicit.
Finding oscillators(const Core& core, const ClaimStarts& starts) {
  constexpr double kBounded = 1.1;
  const ListingStep listing(core.constants.value(), AllParts{}, Bounds{});
  const auto by_core = [&core](const State& body) { return core.flight(body, kSixtieth_s); };
  const auto by_explicit = [&listing](State body) {
    listing.move(body, kSixtieth_s);
    listing.pull(body, kSixtieth_s);
    listing.drag(body);
    return body;
  };
  if (!(core.constants->gravity_px_per_s2 > 0.0) || core.flight({}, kSixtieth_s).vy_px_per_s == 0.0)
    return {.remark = "the spring pulls in the place of gravity, and this core has none"};
  std::vector<double> growths, explicit_euler;
  bool is_less = true;
  for (std::uint64_t start = 0; start < kStarts; ++start) {
    const double angle_rad = random_between(starts.seed, 2 * start, 0.05, 1.99);
    const double phase_rad = random_between(starts.seed, 2 * start + 1, 0.0, 6.283);
    growths.push_back(growth(core, angle_rad, phase_rad, by_core));
    explicit_euler.push_back(growth(core, angle_rad, phase_rad, by_explicit));
    is_less = is_less && growths.back() < explicit_euler.back();
  }
  return finding_of(growths,
                    holds_if(is_less && *std::max_element(growths.begin(), growths.end()) < kBounded),
                    fmt::format("by explicit Euler {:.3g} .. {:.3g}; the core's at 2.01 rad a step {:.3g}",
                                quantile(explicit_euler, 0.1), quantile(explicit_euler, 0.9),
                                growth(core, 2.01, 0.0, by_core)));
}

// A flight, far from all walls, and the exact ones that it is measured against.
struct Flown {
  State run;                // Displacement and velocity.
  State ode;                // Drag is the frames' own.
  double fixed_y_px = 0.0;  // Drag is that of 60 Hz.
};
Flown fly_both(const Core& core, ArcSolution& exact, const Velocity& velocity, double dt_s,
               std::int64_t frames) {
  constexpr double kFar_px = 1e6;
  exact.start(velocity, true);
  for (std::int64_t frame = 0; frame < frames; ++frame) exact.advance(dt_s);
  State run = core.steps({kFar_px, kFar_px, velocity.vx_px_per_s, velocity.vy_px_per_s}, dt_s, kOpen, frames);
  run.x_px -= kFar_px;
  run.y_px -= kFar_px;
  return {run, exact.matched(), exact.model().y_px};
}

// The last number of a start is free.
constexpr std::uint64_t kNumbersOfAStart = 5;
Velocity random_velocity(const ClaimStarts& starts, std::uint64_t start) {
  const auto speed = [&](std::uint64_t which) {
    return random_between(starts.seed, kNumbersOfAStart * start + which, -starts.fastest_px_per_s,
                          starts.fastest_px_per_s);
  };
  return {speed(0), speed(1)};
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// Root mean square errors in y, at the end of flights from all starts.
struct FlightErrors {
  double matched_px = 0.0;  // Against the ODE of the frames' own drag.
  double fixed_px = 0.0;    // Against that of 60 Hz.
};
FlightErrors flight_errors(const Core& core, ArcSolution& exact, const ClaimStarts& starts, double rate_hz) {
  std::vector<double> matched_px, fixed_px;
  for (std::uint64_t start = 0; start < kStarts; ++start) {
    const double about_s = random_between(starts.seed, kNumbersOfAStart * start + 2, 0.25, 1.0);
    const double flight_s = std::round(about_s * starts.slowest_hz) / starts.slowest_hz;
    const Flown flown =
        fly_both(core, exact, random_velocity(starts, start), 1.0 / rate_hz, std::lround(flight_s * rate_hz));
    matched_px.push_back(flown.run.y_px - flown.ode.y_px);
    fixed_px.push_back(flown.run.y_px - flown.fixed_y_px);
  }
  return {root_mean_square(matched_px), root_mean_square(fixed_px)};
}

// A single flight's error can pass through 0 as dt changes (its sign depends on the start), and its order
// with it; the root mean square over the starts cannot.
constexpr int kDoublings = 4;
Finding first_order(const Core& core, const ClaimStarts& starts) {
  constexpr double kTolerance = 0.2;
  const std::optional<Model> model = model_of_core(core);
  if (!model) return {.remark = kNotSolved};
  ArcSolution exact(*model);
  std::vector<double> orders;
  double error_px = flight_errors(core, exact, starts, starts.slowest_hz).matched_px;
  for (int doubling = 1; doubling <= kDoublings; ++doubling) {
    const double before_px = error_px;
    error_px = flight_errors(core, exact, starts, starts.slowest_hz * (1 << doubling)).matched_px;
    orders.push_back(std::log2(before_px / error_px));
  }
  Finding finding = finding_of(orders, ClaimVerdict::holds);
  const double at_60_hz = flight_errors(core, exact, starts, 60.0).fixed_px,
               at_960_hz = flight_errors(core, exact, starts, 960.0).fixed_px;
  if (!(std::fabs(finding.number - 1.0) < kTolerance)) {
    finding.verdict = ClaimVerdict::does_not_hold;
  } else if (!(at_960_hz < at_60_hz)) {
    finding.verdict = ClaimVerdict::holds_when;
    finding.remark =
        "when drag is taken to act once a frame; against a fixed drag rate the error grows from " +
        digits(at_60_hz) + " px at 60 Hz to " + digits(at_960_hz) + " at 960";
  }
  return finding;
}

// Gravity's discretisation alone takes G eta a second, which grows as dt does: 12 times from 1/60 to 0.2 s.
Finding energy_drift(const Core& core, const ClaimStarts& starts) {
  constexpr double kLongFrame_s = 0.2, kShare = 0.5;
  const std::optional<Model> model = model_of_core(core);
  if (!model) return {.remark = kNotSolved};
  ArcSolution exact(*model);
  // Energy of the run minus that of the ODE, at the end.
  const auto drift_px2_per_s2 = [&](const Velocity& velocity, double dt_s, std::int64_t frames) {
    const Flown flown = fly_both(core, exact, velocity, dt_s, frames);
    return energy_gain(flown.ode, flown.run, model->gravity_px_per_s2);
  };
  std::vector<double> ratios, at_60_hz, in_long_frames;
  for (std::uint64_t start = 0; start < kStarts; ++start) {
    const Velocity velocity = random_velocity(starts, start);
    at_60_hz.push_back(drift_px2_per_s2(velocity, kSixtieth_s, 60));
    in_long_frames.push_back(drift_px2_per_s2(velocity, kLongFrame_s, 5));
    ratios.push_back(std::fabs(in_long_frames.back() / at_60_hz.back()));
  }
  return finding_of(
      ratios, holds_if(quantile(ratios, 0.1) > kShare * kLongFrame_s / kSixtieth_s),
      fmt::format("from {:.4g} to {:.4g} px²/s² a second", median(at_60_hz), median(in_long_frames)));
}

// Impacts that an exact motion has within the frames of throws of 3 s, each begun from the run's own state,
// and those beyond the one in x and the one in y that a step can show: it looks at the walls once.
Share missed_impacts(const Core& core, const Model& model, const ClaimStarts& starts, double dt_s) {
  constexpr double kDuration_s = 3.0;
  ExactFling exact{FixedLaws(model)};
  Share missed;
  for (std::uint64_t start = 0; start < kStarts; ++start) {
    const std::uint64_t first = kNumbersOfAStart * start + 3;
    const Velocity velocity = random_velocity(starts, start);
    State body{random_between(starts.seed, first, 0.0, kDesktop.right_px),
               random_between(starts.seed, first + 1, 0.0, kDesktop.bottom_px), velocity.vx_px_per_s,
               velocity.vy_px_per_s};
    for (long frame = std::lround(kDuration_s / dt_s); frame > 0 && is_finite(body); --frame) {
      exact.start(body, kDesktop, false, dt_s);
      (void)exact.at(dt_s);
      body = core.step(body, dt_s, kDesktop);
      const std::vector<ExactImpact>& impacts = exact.impacts();
      const std::int64_t at_sides = std::ranges::count_if(impacts, is_at_side, &ExactImpact::wall);
      const auto not_shown = [](std::int64_t count, double position_px, double far_px) {
        return std::max<std::int64_t>(0, count - (position_px == 0.0 || position_px == far_px ? 1 : 0));
      };
      missed.of += std::ssize(impacts);
      missed.count += not_shown(at_sides, body.x_px, kDesktop.right_px) +
                      not_shown(std::ssize(impacts) - at_sides, body.y_px, kDesktop.bottom_px);
    }
  }
  return missed;
}

Finding missed_collisions(const Core& core, const ClaimStarts& starts) {
  constexpr double kLongFrame_s = 0.25;
  const std::optional<Model> model = model_of_core(core);
  const bool comes_to_rest = model && model->restitution >= 0.0 && model->restitution < 1.0 &&
                             model->rest_threshold_px_per_s > 0.0 && model->ground_friction > 0.0;
  if (!comes_to_rest)
    return {.remark =
                "exact motion has a number of impacts if restitution is below 1 and there is a rest rule"};
  const Share missed = missed_impacts(core, *model, starts, kLongFrame_s),
              at_60_hz = missed_impacts(core, *model, starts, kSixtieth_s);
  const std::string remark =
      fmt::format("of {} impacts; at 60 Hz {} of {}", missed.of, at_60_hz.count, at_60_hz.of);
  if (missed.of == 0 || at_60_hz.of == 0) return {.remark = remark};
  return {missed.part(), holds_if(missed.low() > at_60_hz.high()), remark, {{missed.low(), missed.high()}}};
}

}  // namespace

std::vector<Claim> accuracy_claims(const Core& core, const ClaimStarts& starts) {
  return {
      {{"2.3-oscillators", "more stable than the explicit Euler method for oscillatory systems",
        "growth of a spring's amplitude in 400 of the core's steps beside drag, 100 springs of 0.05 .. 1.99 "
        "rad a step",
        "< 1.1, by explicit Euler more"},
       oscillators(core, starts)},
      {{"2.4-first-order", "the method is only first-order accurate in time",
        fmt::format("order of the error of 100 flights (root mean square), {:g} to {:g} Hz, against the ODE "
                    "of the frames' own drag",
                    starts.slowest_hz, starts.slowest_hz * (1 << kDoublings)),
        "0.8 .. 1.2"},
       first_order(core, starts)},
      {{"4.1-energy-drift", "large dt can cause energy drift",
        "energy drift of a second of flight (run - ODE) in frames of 0.2 s, over that at 60 Hz, 100 flights",
        "> 6, half of 0.2 s * 60 Hz"},
       energy_drift(core, starts)},
      {{"4.1-missed", "large dt can cause missed collisions",
        "part of the impacts of exact motion that steps of 0.25 s do not show, 100 throws of 3 s",
        "> that at 60 Hz, by 95 % intervals"},
       missed_collisions(core, starts)}};
}

}  // namespace hyrax
