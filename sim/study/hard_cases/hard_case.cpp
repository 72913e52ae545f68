#include "sim/study/hard_cases/hard_case.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/compare/expectations.h"
#include "sim/core/listing_core.h"
#include "sim/reference/drift_meter.h"
#include "sim/reference/exact_fling.h"
#include "sim/replay/replay.h"
#include "sim/scenario/schedule.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

// 0 if the sprite has settled with both speeds 0; else below 0, by the speed that is left.
double rest_slack(const RunSummary& summary, double speed_px_per_s) {
  return summary.at_rest_since_s ? -speed_px_per_s : -std::max(speed_px_per_s, 1.0);
}

std::optional<double> value_of(const std::optional<Worst>& worst) {
  return worst ? std::optional(worst->value) : std::nullopt;
}

// Against the closed form alone, in one more run.
RunErrors errors_of(const Core& core, const Scenario& scenario, std::int64_t steps) {
  DriftSink discard;
  DriftMeter meter(scenario, inputs_of(scenario, steps), discard, nullptr, reference_model(core));
  replay(core, scenario, meter);
  const DriftSummary drift = meter.finish();
  return {value_of(drift.implementation_px), value_of(drift.truncation_px),
          value_of(drift.energy_drift_rel_max)};
}

void judge_expectations(const Core& core, PlayedCase& played) {
  const Scenario& scenario = played.hard_case.scenario;
  if (!scenario.expect) return;
  const std::int64_t steps = played.summary.steps;
  std::optional<RunErrors> errors;
  if (bounds_errors(*scenario.expect)) errors = errors_of(core, scenario, steps);
  for (const Expectation& expectation : judge(*scenario.expect, played.summary, errors)) {
    played.measures[static_cast<std::size_t>(Invariant::expectations)].add(expectation.holds ? 0.0 : -1.0,
                                                                           steps);
    if (!expectation.holds && played.broken_expectation.empty())
      played.broken_expectation = expectation.rule + ": wanted " + expectation.wanted;
  }
}

// The part of the start's energy v^2 / 2 + G (bottom - y) that is left at the end.
double kept_energy(const Core& core, const Scenario& scenario, const Row& last) {
  const auto energy = [gravity = core.constants.value().gravity_px_per_s2,
                       bounds = bounds_of(scenario.window, scenario.sprite)](const State& body) {
    return (body.vx_px_per_s * body.vx_px_per_s + body.vy_px_per_s * body.vy_px_per_s) / 2 +
           gravity * (bounds.bottom_px - body.y_px);
  };
  return energy(state_of(last)) / energy(start_state(scenario));
}

// By how much less than rounding the exact flings from the start, and from each pair of doubles up to six
// beside it, miss the corner or gain energy, as height. Infinite: one is outside, or meets another wall.
double corner_slack_px(const Model& model, const HardCase& hard_case) {
  const State start = start_state(hard_case.scenario);
  const Bounds bounds = bounds_of(hard_case.scenario.window, hard_case.scenario.sprite);
  const double gravity = model.gravity_px_per_s2, speed = std::hypot(start.vx_px_per_s, start.vy_px_per_s);
  const auto beside = [](double place, int doubles) {
    return place + doubles * (std::nextafter(place, HUGE_VAL) - place);
  };
  double fault_px = 0.0;
  for (int each = 0; each < 13 * 13; ++each) {
    State last = start;
    last.x_px = beside(start.x_px, each / 13 - 6);
    last.y_px = beside(start.y_px, each % 13 - 6);
    ExactFling fling{FixedLaws(model)};
    fling.start(last, bounds);
    for (double t_s = 0.0; t_s < 4.0; t_s += 0.0625) {
      const State now = fling.at(t_s);
      fault_px = std::max(fault_px, energy_gain(last, now, gravity) / gravity);
      last = now;
    }
    const std::vector<ExactImpact>& met = fling.impacts();
    if (!fling.is_sound() || met.size() < 2 ||
        (static_cast<int>(met[0].wall) | static_cast<int>(met[1].wall)) != hard_case.exact_corner)
      return -HUGE_VAL;
    fault_px = std::max(fault_px, (met[1].t_s - met[0].t_s) * speed);
  }
  return 1e-12 * (bounds.right_px + bounds.bottom_px + speed * speed / gravity) - fault_px;
}

}  // namespace

Core lossless(const Core& core) {
  return listing_core({.gravity_px_per_s2 = core.constants.value().gravity_px_per_s2,
                       .restitution = 1.0,
                       .air_drag = 1.0,
                       .ground_friction = 1.0,
                       .rest_threshold_px_per_s = 0.0});
}

PlayedCase play_hard_case(const Core& core, HardCase hard_case,
                          const std::function<void(std::int64_t)>& report_steps) {
  const Scenario& scenario = hard_case.scenario;
  const Core& playing = hard_case.is_lossless ? lossless(core) : core;
  PlayedCase played{check_run(
      playing, scenario, hard_case.stops.empty() ? usual_stops(scenario) : hard_case.stops, report_steps)};
  played.hard_case = std::move(hard_case);
  const auto measure = [&](Invariant invariant, double slack) {
    played.measures[static_cast<std::size_t>(invariant)].add(slack, played.summary.steps);
  };
  if (played.hard_case.must_come_to_rest)
    measure(Invariant::comes_to_rest, rest_slack(played.summary, played.last_speed_px_per_s));
  if (played.hard_case.rests_from_s)
    measure(
        Invariant::stays_at_rest,
        *played.hard_case.rests_from_s - played.summary.at_rest_since_s.value_or(played.summary.simulated_s));
  if (played.hard_case.is_lossless)
    measure(Invariant::keeps_energy,
            kept_energy(playing, played.hard_case.scenario, played.summary.final) - 0.5);
  if (played.hard_case.exact_corner != 0)
    measure(Invariant::exact_corner, corner_slack_px(reference_model(core), played.hard_case));
  judge_expectations(core, played);
  return played;
}

CaseVerdict judge(const PlayedCase& played, Invariant invariant) {
  const bool is_known = (invariant == Invariant::comes_to_rest && !played.hard_case.never_at_rest.empty()) ||
                        (invariant == Invariant::stays_at_rest && !played.hard_case.thrown_at_rest.empty());
  if (played.measures[static_cast<std::size_t>(invariant)].holds)
    return is_known ? CaseVerdict::expected_failure_gone : CaseVerdict::held;
  // The listing itself applies drag in a zero-length frame, in the user's own scenarios as well; of bounces
  // without loss each returns up to G dt less speed than it got.
  return is_known || invariant == Invariant::keeps_energy ||
                 is_broken_by_listing(invariant, played.hard_case.scenario)
             ? CaseVerdict::expected_failure
             : CaseVerdict::broken;
}

}  // namespace hyrax
