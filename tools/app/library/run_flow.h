// `run` for any core: which scenarios are played into which files.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/compare/expectations.h"
#include "tools/app/command_line/command_results.h"
#include "tools/app/command_line/options.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {

struct RunRequest {
  std::vector<std::string> files;
  std::string output;
  std::vector<std::string> overrides;
  std::string figure;
  std::string page;
  std::string golden_folder;
  bool measures_drift = false;  ///< Of the paper's step.
  Printing printing;
};
void declare_run(Options& options, RunRequest& request, const std::string& figure_help,
                 const std::string& page_help);

/// A scenario that was read.
struct LoadedScenario {
  std::string name;
  /// Plays it into a file, or kStandardOutput, and reports.
  std::function<void(const std::string& output, CommandResults& results)> run;
};

/// Reads all scenarios, then runs them; of more than three a line each is printed, unless all is asked for.
/// @param load throws a Failure where the file is bad.
/// @param require is called with the outputs before the first is written; may throw.
[[nodiscard]] ExitCode run_scenarios(
    RunRequest& request,
    const std::function<LoadedScenario(const std::string& path, const std::vector<Override>&)>& load,
    const std::function<void(const std::vector<std::string>& outputs)>& require = {});

/// "  written        FILE", or "written: FILE".
void print_written(const RunRequest& request, const std::string& path);
/// The command that writes the page again.
[[nodiscard]] std::string page_command(const RunRequest& request, const std::string& scenario_path);

/// "nothing", or the names.
[[nodiscard]] std::string joined_names(const std::vector<std::string>& names);
/// Those that do not hold, or all.
void print_expectations(const std::vector<Expectation>& expectations, bool all);

}  // namespace hyrax
