// Plays a scenario and judges it by its `expect`, without HDF5 and GSL.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/compare/expectations.h"
#include "sim/core/core.h"
#include "sim/reference/drift.h"
#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"
#include "tools/files/json.h"

namespace hyrax {

/// The options of a replay whose summary has all that `expect` judges.
[[nodiscard]] ReplayOptions judged_options(const Scenario& scenario);

/// Plays the scenario for its summary alone.
[[nodiscard]] RunSummary play(const Core& core, const Scenario& scenario);

/// The verdicts on the scenario's `expect`.
/// @param measured the errors against the reference; without it the run is played again where one is bounded.
[[nodiscard]] std::vector<Expectation> judge_run(const Core& core, const Scenario& scenario,
                                                 const RunSummary& summary,
                                                 std::optional<DriftSummary> measured = std::nullopt);

/// Those that do not hold.
[[nodiscard]] std::vector<Expectation> broken_expectations(const Core& core, const Scenario& scenario,
                                                           const RunSummary& summary);

/// Whether a run can give an expectation that does not hold a new range: a count, a range with two ends. No
/// error bound or one-sided limit, and nothing that the run does not have.
[[nodiscard]] bool is_updatable_range(const Expectation& broken);

/// The same, or the state hash; no boolean.
[[nodiscard]] bool is_updatable(const Expectation& broken);

/// A verdict of `expect`: {"rule", "holds", "measured"}.
[[nodiscard]] Json expectation_json(const Expectation& expectation);
/// "at_rest_since_s: wanted 3 .. 4, measured 5.25".
[[nodiscard]] std::string expectation_text(const Expectation& expectation);
/// "expect RULE: wanted ..., measured ...; RULE: ..."; empty without any.
[[nodiscard]] std::string broken_sentence(const std::vector<Expectation>& broken);

}  // namespace hyrax
