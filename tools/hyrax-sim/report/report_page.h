// The report: trajectory files as one HTML page that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "tools/files/json.h"

namespace hyrax {

/// More rows of a file than this are not put into a page: the page plays them again from the scenario.
inline constexpr std::int64_t kPageRowsMax = 5'000;

struct ReportRequest {
  std::vector<std::string> files;  ///< Trajectories, at least one.
  std::string against;             ///< The trajectory that they are compared with; empty: none.
  std::string output;              ///< FILE.html.
  std::string command;             ///< What made it, for the page.
};

/// What the page is told: the runs, their verdicts, and what of their rows it must replay bit for bit.
/// ERRORS: as TrajectoryFile::open's.
[[nodiscard]] Json report_data(const ReportRequest& request);

/// Throws Failure(cannot_access) if this program was built without the page, and says how to build it.
void require_page();

/// Writes the page.
/// ERRORS: as require_page's and report_data's; Failure(cannot_access) if `output` cannot be written.
void write_report(const ReportRequest& request);

}  // namespace hyrax
