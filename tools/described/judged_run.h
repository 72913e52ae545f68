// A scenario, played and judged: by itself, by its `expect`, and by its golden file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/compare/expectations.h"
#include "tools/described/golden_run.h"
#include "tools/files/check_status.h"
#include "tools/files/golden_place.h"
#include "tools/files/json.h"

namespace hyrax {

struct DescribedRun {
  std::string path;  ///< As given.
  DescribedScenario scenario = {};
  GoldenContents contents = {};
  /// What does not hold, whatever it is compared with: an early end, a broken property, an incomplete
  /// description.
  std::vector<std::string> faults = {};
  std::vector<Expectation> expectations = {};
  std::optional<GoldenPlace> place = {};
  std::string not_compared = {};  ///< Why there is no place; empty: there is one.
  bool has_golden = false;
  std::optional<GoldenComparison> comparison = {};
  std::string error = {};  ///< Of one that failed.
  CheckStatus status = CheckStatus::agreed;
  ExitCode exit_code = ExitCode::agreed;
  double seconds = 0.0;

  [[nodiscard]] std::vector<Expectation> broken() const;
  /// Whether nothing is wrong, a missing golden file apart.
  [[nodiscard]] bool holds() const;
  /// What is wrong, in one line without the path; empty: nothing.
  [[nodiscard]] std::string sentence() const;
};

struct JudgeOptions {
  std::string golden_folder = {};  ///< As given with --golden; empty if it was not.
  bool compares = true;            ///< With a golden file, if there is one.
  std::vector<DescribedSink*> also = {};
};

/// Plays, checks the description, judges and compares. REQUIRES: as read_isolated.
/// ERRORS: as compare_with_golden's.
[[nodiscard]] DescribedRun judge_run(const DescribedCore& core, const std::string& path,
                                     const DescribedScenario& scenario, const JudgeOptions& options);

/// The same of a scenario file; an error becomes part of it.
[[nodiscard]] DescribedRun judge_file(const DescribedCore& core, const std::string& path,
                                      const std::string& golden_folder);

}  // namespace hyrax
