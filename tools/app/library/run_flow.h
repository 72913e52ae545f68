// `run` for any core: which scenarios are played into which files.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/compare/expectations.h"
#include "tools/app/command_line/command_results.h"
#include "tools/app/command_line/options.h"
#include "tools/files/scenario_reader.h"
#include "tools/report/contact_sheet.h"

namespace hyrax {

struct RunRequest {
  std::vector<std::string> files;
  std::string output;
  std::vector<std::string> overrides;
  std::string figure;
  std::string page;
  std::string golden_folder;
  bool measures_drift = false;  ///< Of the paper's step.
  bool shows_sheet = false;     ///< Of several scenarios the figure and the page are those of all.
  Printing printing;
};
void declare_run(Options& options, RunRequest& request, const std::string& figure_help,
                 const std::string& page_help);

/// A scenario that was read.
struct LoadedScenario {
  std::string name;
  /// Plays it into a file, or kStandardOutput, and reports. What it returns is for a sheet.
  std::function<RunPanel(const std::string& output, CommandResults& results)> run;
};

/// What `run` does besides.
struct RunSteps {
  /// Is called with the outputs before the first is written; may throw.
  std::function<void(const std::vector<std::string>& outputs)> require = {};
  /// Writes the page of several; those that failed have no link.
  std::function<void(const std::vector<RunPanel>& panels)> write_page = {};
};

/// Reads all scenarios, then runs them; of more than three a line each is printed, unless all is asked for.
/// @param load throws a Failure where the file is bad.
[[nodiscard]] ExitCode run_scenarios(
    RunRequest& request,
    const std::function<LoadedScenario(const std::string& path, const std::vector<Override>&)>& load,
    const RunSteps& steps);

/// "  written        FILE", or "written: FILE".
void print_written(const RunRequest& request, const std::string& path);
/// The command that writes the page again. @param scenarios their paths.
[[nodiscard]] std::string page_command(const RunRequest& request, const std::vector<std::string>& scenarios);

/// "nothing", or the names.
[[nodiscard]] std::string joined_names(const std::vector<std::string>& names);
/// Those that do not hold, or all.
void print_expectations(const std::vector<Expectation>& expectations, bool all);

}  // namespace hyrax
