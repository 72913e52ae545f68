// The report: trajectory files as one HTML page that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/schedule.h"
#include "tools/files/json.h"
#include "tools/report/contact_sheet.h"
#include "tools/report/result_page.h"

namespace hyrax {

/// More rows of a file than this are not put into a page: the page plays them again from the scenario.
inline constexpr std::int64_t kPageRowsMax = 5'000;

struct ReportRequest {
  std::vector<std::string> files;         ///< Trajectories, at least one.
  std::string against = {};               ///< The trajectory that they are compared with; empty: none.
  std::vector<std::string> goldens = {};  ///< If there are any, in its place: one a file; empty: none.
  std::string output;                     ///< FILE.html.
  std::string command;                    ///< What made it, for the page.
  std::vector<RunPanel> panels = {};      ///< Of the sheet of several; empty: made of the files.
};

/// Whether a page's own core is this one; else it is that of another header (tools/check), or the page was
/// not built again. A program without pages has none that differs.
[[nodiscard]] bool is_core_of_page(const Core& core);

/// The data of the page: the runs, their verdicts, and the rows that it must replay bit for bit.
/// ERRORS: as TrajectoryFile::open's.
[[nodiscard]] Json report_data(const Core& core, const ReportRequest& request);

/// A sweep's file as its page shows it. ERRORS: as EnsembleReader's.
[[nodiscard]] ShownResult sweep_result(const Core& core, const std::string& path);

/// What the page of trajectories shows without JavaScript: of each run its name and verdict, of one its path.
[[nodiscard]] std::string still_html(const ReportRequest& request, const Json& data);

/// Doubles as base64 of little-endian binary64: exact, and a third of their decimal text.
[[nodiscard]] Json doubles_json(const std::vector<double>& values);

/// The inputs of a run: all resizes, which the drawing needs, and the first of the others.
[[nodiscard]] Json inputs_json(const std::vector<Input>& inputs);

/// The constants that a run is played with, in the order of trajectory files: {"names": by the core's names
/// of them, "values", "given": those that the scenario gives}. Null: the core's step is not the paper's.
/// @param core with the run's parameters.
[[nodiscard]] Json parameters_json(const Core& core);

/// Writes the page of trajectories, or of sweeps if the first file is one.
/// ERRORS: as report_data's, sweep_result's and write_page_file's; Failure(bad_input) if files of both kinds
/// are given, sweeps are to be compared, or the first file is a study's.
void write_report(const Core& core, const ReportRequest& request);

}  // namespace hyrax
