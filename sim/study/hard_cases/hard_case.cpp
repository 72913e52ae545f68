#include "sim/study/hard_cases/hard_case.h"

#include <algorithm>
#include <optional>

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

void judge_expectations(const Core& core, const Scenario& scenario, HardCaseResult& result) {
  const std::optional<Expect>& expect = scenario.expect;
  if (!expect) return;
  const std::int64_t steps = result.summary.steps;
  std::optional<RunErrors> errors;
  if (bounds_errors(*expect)) errors = errors_of(core, scenario, steps);
  for (const Expectation& expectation : judge(*expect, result.summary, errors)) {
    result.measures[static_cast<std::size_t>(Invariant::expectations)].add(expectation.holds ? 0.0 : -1.0,
                                                                           steps);
    if (!expectation.holds && result.broken_expectation.empty())
      result.broken_expectation = expectation.rule + ": wanted " + expectation.wanted;
  }
}

}  // namespace

HardCaseResult play_hard_case(const Core& core, const HardCase& hard_case,
                              const std::function<void(std::int64_t)>& report_steps) {
  const Scenario& scenario = hard_case.scenario;
  HardCaseResult result{check_run(core, scenario, usual_stops(scenario), report_steps)};
  if (hard_case.must_come_to_rest)
    result.measures[static_cast<std::size_t>(Invariant::comes_to_rest)].add(
        rest_slack(result.summary, result.last_speed_px_per_s), result.summary.steps);
  judge_expectations(core, scenario, result);
  return result;
}

CaseVerdict judge(const HardCase& hard_case, const HardCaseResult& result, Invariant invariant) {
  const bool is_known = invariant == Invariant::comes_to_rest && !hard_case.never_at_rest.empty();
  const bool holds = result.measures[static_cast<std::size_t>(invariant)].holds;
  // The listing itself applies drag in a zero-length frame, in the user's own scenarios as well.
  const bool is_expected_failure = is_known || is_broken_by_listing(invariant, hard_case.scenario);
  if (holds) return is_known ? CaseVerdict::expected_failure_gone : CaseVerdict::held;
  return is_expected_failure ? CaseVerdict::expected_failure : CaseVerdict::broken;
}

std::vector<Judgement> judgements_of(std::span<const PlayedCase> cases) {
  std::vector<Judgement> judgements;
  for (const PlayedCase& played : cases)
    for (std::size_t index = 0; index < kInvariantCount; ++index) {
      const auto invariant = static_cast<Invariant>(index);
      if (played.result.measures[index].is_checked)
        judgements.push_back({&played, invariant, judge(played.hard_case, played.result, invariant)});
    }
  return judgements;
}

InvariantCount count(const std::vector<Judgement>& judgements, Invariant invariant,
                     const std::string& made_from) {
  InvariantCount count;
  for (const Judgement& judgement : judgements) {
    const HardCase& hard_case = judgement.played->hard_case;
    if (judgement.invariant != invariant || (!made_from.empty() && hard_case.made_from != made_from))
      continue;
    ++count.cases;
    const double slack = judgement.measure().slack;
    if (judgement.verdict == CaseVerdict::expected_failure)
      ++count.expected_failures;
    else if (judgement.verdict != CaseVerdict::held)
      ++count.broken;
    else if (++count.held == 1 || slack < count.slack) {
      count.slack = slack;
      count.least_slack_case = hard_case.name;
    }
  }
  return count;
}

}  // namespace hyrax
