#include "sim/study/hard_cases/hard_case.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/compare/expectations.h"
#include "sim/reference/drift_meter.h"
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

}  // namespace

PlayedCase play_hard_case(const Core& core, HardCase hard_case,
                          const std::function<void(std::int64_t)>& report_steps) {
  const Scenario& scenario = hard_case.scenario;
  PlayedCase played{check_run(
      core, scenario, hard_case.stops.empty() ? usual_stops(scenario) : hard_case.stops, report_steps)};
  played.hard_case = std::move(hard_case);
  if (played.hard_case.must_come_to_rest)
    played.measures[static_cast<std::size_t>(Invariant::comes_to_rest)].add(
        rest_slack(played.summary, played.last_speed_px_per_s), played.summary.steps);
  judge_expectations(core, played);
  return played;
}

CaseVerdict judge(const PlayedCase& played, Invariant invariant) {
  const bool is_known = invariant == Invariant::comes_to_rest && !played.hard_case.never_at_rest.empty();
  if (played.measures[static_cast<std::size_t>(invariant)].holds)
    return is_known ? CaseVerdict::expected_failure_gone : CaseVerdict::held;
  // The listing itself applies drag in a zero-length frame, in the user's own scenarios as well.
  return is_known || is_broken_by_listing(invariant, played.hard_case.scenario)
             ? CaseVerdict::expected_failure
             : CaseVerdict::broken;
}

}  // namespace hyrax
