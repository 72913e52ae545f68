// The verdict of `check` on one scenario, and on all.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/compare/expectations.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"
#include "tools/hyrax-sim/command_line/print.h"
#include "tools/store/golden_place.h"

namespace hyrax {

struct CheckVerdict {
  enum class Status { agreed, disagreed, missing, failed, unreferenced };
  std::string path;  ///< Of the scenario as given; of an unreferenced golden file without its suffix.
  Status status = Status::agreed;
  std::optional<GoldenPlace> golden;
  bool has_golden = false;    ///< Its golden file exists.
  std::string golden_folder;  ///< As given with --golden; empty if it was not.
  Comparison comparison;
  std::vector<Expectation> broken;  ///< Expectations that do not hold.
  std::string error;                ///< Of a failed one.
  std::string note;                 ///< A remark on one that agrees; may be empty.
  bool is_open = false;             ///< Undecided: the golden file must be read.
  ExitCode exit_code = ExitCode::agreed;
  double seconds = 0.0;
};

[[nodiscard]] std::string_view name_of(CheckVerdict::Status status);

struct CheckOptions {
  std::string golden_folder;
  bool reads_golden = true;  ///< If the summary does not decide. REQUIRES: no other threads.
};

/// Plays a scenario and compares; never throws Failure: it becomes a verdict.
[[nodiscard]] CheckVerdict check_scenario(const std::string& path, const CheckOptions& options);

/// The golden files without a scenario, each once: for every folder among `arguments` that is named
/// `scenarios` or below one, those in the corresponding golden folder, recursively. They are exit 1, as a
/// disagreement: an accepted result is not checked any more. A golden folder that cannot be read becomes a
/// failed verdict.
[[nodiscard]] std::vector<CheckVerdict> find_unreferenced(const std::vector<std::string>& arguments,
                                                          const std::string& golden_folder);

/// Prints each verdict that is not "agreed" (verbose: all), and the counts (quiet: nothing else).
void print_check(const std::vector<CheckVerdict>& verdicts, const Printing& printing);
[[nodiscard]] Json check_json(const std::vector<CheckVerdict>& verdicts);
[[nodiscard]] std::string check_junit(const std::vector<CheckVerdict>& verdicts);

}  // namespace hyrax
