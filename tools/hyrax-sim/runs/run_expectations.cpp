#include "tools/hyrax-sim/runs/run_expectations.h"

#include "tools/hyrax-sim/drift/drift_run.h"

namespace hyrax {
namespace {

std::optional<double> value_of(const std::optional<Worst>& worst) {
  if (!worst) return std::nullopt;
  return worst->value;
}

RunErrors errors_of(const Scenario& scenario, const RunSummary& summary) {
  const DriftSummary drift = summarize_drift(rows_of(scenario, summary));
  return {value_of(drift.implementation_px), value_of(drift.truncation_px),
          value_of(drift.energy_drift_rel_max)};
}

}  // namespace

std::vector<Expectation> judge_run(const Scenario& scenario, const RunSummary& summary) {
  if (!scenario.expect) return {};
  if (!bounds_errors(*scenario.expect)) return judge(*scenario.expect, summary);
  return judge(*scenario.expect, summary, errors_of(scenario, summary));
}

}  // namespace hyrax
