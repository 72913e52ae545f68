#include "sim/study/hard_cases/hard_case.h"

#include <algorithm>
#include <optional>

#include "sim/compare/expectations.h"
#include "sim/reference/drift_meter.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/study/hard_cases/step_watch.h"

namespace hyrax {
namespace {

// Takes the digest of the rows that pass.
class DigestSink : public RowSink {
 public:
  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void rows(const Columns& batch) override {
    for (std::size_t row = 0; row < batch.size(); ++row) hash_.add(batch.row(row));
  }
  [[nodiscard]] Digest finish() { return hash_.value(); }

 private:
  StateHash hash_;
};

// Passes rows on and reports how many have passed.
class ProgressSink : public RowSink {
 public:
  ProgressSink(RowSink& sink, const std::function<void(std::int64_t)>& report_steps)
      : sink_(sink), report_steps_(report_steps) {}
  [[nodiscard]] Wants wants() const override { return sink_.wants(); }
  void rows(const Columns& batch) override {
    sink_.rows(batch);
    if (report_steps_ && batch.size() > 0) report_steps_(batch.row(batch.size() - 1).step);
  }

 private:
  RowSink& sink_;
  const std::function<void(std::int64_t)>& report_steps_;
};

// At the first input past the start, if there is one, and at two thirds.
std::vector<std::int64_t> stops_of(const Scenario& scenario, std::int64_t steps) {
  std::vector<std::int64_t> stops{steps / 3, 2 * steps / 3};
  for (const std::int64_t frame : schedule_events(scenario, steps).frames)
    if (frame > 0) {
      stops.front() = frame;
      break;
    }
  std::sort(stops.begin(), stops.end());
  return stops;
}

Digest resumed_digest(const Scenario& scenario) {
  DigestSink sink;
  std::optional<Replay> run(std::in_place, scenario, sink);
  for (const std::int64_t stop : stops_of(scenario, run->steps())) {
    run->play_to(stop);
    const Keyframe stopped = run->keyframe();
    run->finish();
    run.emplace(scenario, stopped, sink);
  }
  run->play_to(run->steps());
  run->finish();
  return sink.finish();
}

double zero_or_less(bool holds) { return holds ? 0.0 : -1.0; }

// Settled, and both speeds 0.
double rest_margin(const RunSummary& summary, double speed_px_per_s) {
  return summary.at_rest_since_s ? -speed_px_per_s : -std::max(speed_px_per_s, 1.0);
}

std::optional<double> value_of(const std::optional<Worst>& worst) {
  return worst ? std::optional(worst->value) : std::nullopt;
}

// Against the closed form alone, in one more run.
RunErrors errors_of(const Scenario& scenario, std::int64_t steps) {
  DriftSink discard;
  DriftMeter meter(scenario, inputs_of(scenario, steps), discard);
  replay(scenario, meter);
  const DriftSummary drift = meter.finish();
  return {value_of(drift.implementation_px), value_of(drift.truncation_px),
          value_of(drift.energy_drift_rel_max)};
}

void judge_expectations(const HardCase& hard_case, const RunSummary& summary, HardCaseResult& result) {
  const std::optional<Expect>& expect = hard_case.scenario.expect;
  if (!expect) return;
  std::optional<RunErrors> errors;
  if (bounds_errors(*expect)) errors = errors_of(hard_case.scenario, summary.steps);
  for (const Expectation& expectation : judge(*expect, summary, errors)) {
    result.measures[static_cast<std::size_t>(Invariant::expectations)].add(zero_or_less(expectation.holds),
                                                                           summary.steps);
    if (!expectation.holds && result.broken_expectation.empty())
      result.broken_expectation = expectation.rule + ": wanted " + expectation.wanted;
  }
}

}  // namespace

HardCaseResult play_hard_case(const HardCase& hard_case,
                              const std::function<void(std::int64_t)>& report_steps) {
  const Scenario& scenario = hard_case.scenario;
  StepWatch watch(scenario);
  ProgressSink counted(watch, report_steps);
  const RunSummary watched = replay(scenario, counted, {.skips_repetition = false, .checks_bounds = true});
  HardCaseResult result{.measures = watch.measures(),
                        .steps = watched.steps,
                        .knife_edges = watch.knife_edges(),
                        .broken_expectation = {}};
  const auto record = [&](Invariant invariant, double margin) {
    result.measures[static_cast<std::size_t>(invariant)].add(margin, watched.steps);
  };
  RowSink discard;
  record(Invariant::repeated, zero_or_less(replay(scenario, discard).state_hash == watched.state_hash));
  record(Invariant::resumed, zero_or_less(resumed_digest(scenario) == watched.state_hash));
  if (hard_case.must_come_to_rest)
    record(Invariant::comes_to_rest, rest_margin(watched, watch.last_speed_px_per_s()));
  judge_expectations(hard_case, watched, result);
  return result;
}

CaseVerdict judge(const HardCase& hard_case, const HardCaseResult& result, Invariant invariant) {
  const bool is_known =
      std::any_of(hard_case.expected_failures.begin(), hard_case.expected_failures.end(),
                  [&](const ExpectedFailure& failure) { return failure.invariant == invariant; });
  const bool holds = result.measures[static_cast<std::size_t>(invariant)].holds;
  // The listing itself applies drag in a zero-length frame, in the user's own scenarios as well.
  const bool is_expected_failure = is_known || invariant == Invariant::no_time;
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
    const double margin = judgement.measure().margin;
    if (judgement.verdict == CaseVerdict::expected_failure)
      ++count.expected_failures;
    else if (judgement.verdict != CaseVerdict::held)
      ++count.broken;
    else if (++count.held == 1 || margin < count.margin) {
      count.margin = margin;
      count.least_margin_case = hard_case.name;
    }
  }
  return count;
}

}  // namespace hyrax
