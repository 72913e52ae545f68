// One scenario played for `run`: into a file, with what its author and its golden file say of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/compare/expectations.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/run_summary.h"
#include "tools/hyrax-sim/runs/written_run.h"

namespace hyrax {

struct ScenarioRunOptions {
  std::string golden_folder;  ///< Empty: the `golden` beside the nearest `scenarios`.
  bool skips_repetition = true;
  bool compares = true;  ///< With the golden file, if there is one.
  std::optional<StoredDrift> drift;
};

struct ScenarioRun {
  std::string path;  ///< As given.
  Scenario scenario;
  RunSummary summary;
  std::string output;
  std::int64_t rows_recorded = 0;
  std::optional<DriftRun> drift;  ///< On request.
  std::vector<Expectation> expectations;
  std::string golden_path;               ///< Empty where none was looked for.
  std::string golden_folder;             ///< As given; empty where it was not.
  std::string not_compared;              ///< Why none was looked for; else empty.
  std::optional<Comparison> comparison;  ///< With the golden file; nothing where there is none.

  [[nodiscard]] bool is_as_expected() const;
};

/// Plays the scenario and writes `output`, then judges.
/// ERRORS: Failure(cannot_access) for the output, Failure of reading the golden file.
[[nodiscard]] ScenarioRun run_scenario(const std::string& path, const Scenario& scenario,
                                       const std::string& output, const ScenarioRunOptions& options);

}  // namespace hyrax
