// The verdict of `check` on one scenario, and on all.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/compare/expectations.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"
#include "tools/store/golden_place.h"

namespace hyrax {

struct CheckVerdict {
  enum class Status { agreed, disagreed, missing, failed, unreferenced };
  std::string path;  ///< Of the scenario as given; of an unreferenced golden file without its suffix.
  Status status = Status::agreed;
  std::optional<GoldenPlace> golden;
  std::string golden_folder;  ///< As given with --golden; empty where it was not.
  Comparison comparison;
  std::vector<Expectation> broken;  ///< Expectations that do not hold.
  std::string error;                ///< Of a failed one.
  std::string note;                 ///< What is worth knowing of one that agrees; else empty.
  bool is_open = false;             ///< Nothing is said yet: the golden file would have to be read.
  ExitCode exit_code = ExitCode::agreed;
  double seconds = 0.0;
};

[[nodiscard]] std::string_view name_of(CheckVerdict::Status status);

struct CheckOptions {
  std::string golden_folder;
  bool reads_golden = true;  ///< Where the summary does not decide. Not with other threads about.
};

/// Plays a scenario and compares; never throws Failure: it becomes a verdict.
[[nodiscard]] CheckVerdict check_scenario(const std::string& path, const CheckOptions& options);

/// The golden files that no scenario refers to, each once: of every folder of scenarios named `scenarios` or
/// below one, what is in the corresponding golden folder, recursively. A file among `arguments` adds none,
/// so that checking one scenario never depends on another. They are exit 1, as a disagreement: what was
/// accepted as a result is not checked any more. A golden folder that cannot be read becomes a failed
/// verdict.
[[nodiscard]] std::vector<CheckVerdict> find_unreferenced(const std::vector<std::string>& arguments,
                                                          const std::string& golden_folder);

// The verdicts in words, in JSON, and as JUnit XML.
[[nodiscard]] std::string check_text(const std::vector<CheckVerdict>& verdicts);
[[nodiscard]] Json check_json(const std::vector<CheckVerdict>& verdicts);
[[nodiscard]] std::string check_junit(const std::vector<CheckVerdict>& verdicts);

}  // namespace hyrax
