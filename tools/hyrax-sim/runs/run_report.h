// What `run` found, in words and in JSON.
#pragma once

#include <string>
#include <vector>

#include "tools/files/json.h"
#include "tools/hyrax-sim/runs/scenario_run.h"

namespace hyrax {

/// What the scene exercised, what it never touched, and what was not computed.
struct Coverage {
  std::vector<std::string> exercised;
  std::vector<std::string> never_touched;
  std::vector<std::string> not_computed;
};
[[nodiscard]] Coverage coverage_of(const ScenarioRun& run);

[[nodiscard]] std::string run_text(const ScenarioRun& run);

/// An entry of "runs".
[[nodiscard]] Json run_json(const ScenarioRun& run);

/// A verdict of `expect`: {"rule", "holds", "measured"}.
[[nodiscard]] Json expectation_json(const Expectation& expectation);
/// "at_rest_since_s: wanted 3 .. 4, measured 5.25".
[[nodiscard]] std::string expectation_text(const Expectation& expectation);

}  // namespace hyrax
