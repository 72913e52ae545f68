// What a scenario's author means to hold, measured as far as it asks for.
#pragma once

#include <vector>

#include "sim/compare/expectations.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

/// The verdicts on a run of the scenario. Only where `expect` bounds an error against the reference is
/// the run played once more and measured, by the closed form alone.
[[nodiscard]] std::vector<Expectation> judge_run(const Scenario& scenario, const RunSummary& summary);

}  // namespace hyrax
