// A scenario, played and judged: by itself, by its `expect`, and by its golden file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/app/library/scenario_verdict.h"
#include "tools/described/golden_run.h"
#include "tools/described/run_text.h"

namespace hyrax {

struct DescribedRun final : ScenarioVerdict {
  DescribedScenario scenario = {};
  GoldenContents contents = {};
  std::vector<Expectation> expectations = {};
  std::string not_compared = {};  ///< Why there is no place; empty: there is one.
  std::optional<GoldenComparison> comparison = {};

  [[nodiscard]] bool differs() const override { return comparison && !comparison->agrees(); }
  [[nodiscard]] Deviation deviation() const override;
  [[nodiscard]] std::string consequence() const override;
  [[nodiscard]] std::string first_difference() const override;
  [[nodiscard]] std::string differences_text(bool lists_all) const override;
  [[nodiscard]] Json::Object differences_json() const override;

  /// By the scenario's `expect`.
  void judge(const Description& description);
  /// Whether nothing is wrong, a missing golden file apart.
  [[nodiscard]] bool holds() const { return faults.empty() && broken.empty() && !differs(); }
  /// What is wrong, in one line without the path; empty: nothing.
  [[nodiscard]] std::string sentence() const;
};

/// Its golden file, which it differs from; else null. ERRORS: as FileRun's.
[[nodiscard]] std::unique_ptr<FileRun> differing_golden(const DescribedCore& core, const DescribedRun& run);

struct JudgeOptions {
  std::string golden_folder = {};  ///< As given with --golden; empty if it was not.
  bool compares = true;            ///< With a golden file, if there is one.
  bool reads_golden = true;        ///< If its summary does not decide. REQUIRES: no other threads.
  std::vector<DescribedSink*> also = {};
  bool draws = false;  ///< Of a file: the run, for a sheet.
};

/// Plays the scenario, checks the description, judges and compares. REQUIRES: path and scenario are set; as
/// read_isolated.
/// ERRORS: as compare_with_golden's.
void judge_run(const DescribedCore& core, DescribedRun& run, const JudgeOptions& options);

/// The same of a scenario file; an error becomes part of it.
[[nodiscard]] DescribedRun judge_file(const DescribedCore& core, const std::string& path,
                                      const JudgeOptions& options);

}  // namespace hyrax
