// The verdict of `check` on one scenario, and on all.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/compare/expectations.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"

namespace hyrax {

struct CheckVerdict {
  enum class Status { agreed, disagreed, missing, failed };
  std::string path;
  Status status = Status::agreed;
  std::string golden_path;
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
  bool is_quick = false;     ///< The digest's hash decides; rows are read only on a mismatch.
  bool reads_golden = true;  ///< Where the digest does not decide. Not with other threads about.
};

/// Plays a scenario and compares; never throws Failure: it becomes a verdict.
[[nodiscard]] CheckVerdict check_scenario(const std::string& path, const CheckOptions& options);

// The verdicts in words, in JSON, and as JUnit XML.
[[nodiscard]] std::string check_text(const std::vector<CheckVerdict>& verdicts);
[[nodiscard]] Json check_json(const std::vector<CheckVerdict>& verdicts);
[[nodiscard]] std::string check_junit(const std::vector<CheckVerdict>& verdicts);

}  // namespace hyrax
