#include "tools/app/report/report_page.h"

#include <algorithm>

#include "sim/replay/fingerprint.h"
#include "sim/trajectory/physics_model.h"
#include "tools/files/failure.h"
#include "tools/report/page_file.h"

namespace hyrax {
namespace {

// Whether the page replays what it shows.
bool write_results(const Core& core, const ReportRequest& request) {
  if (!request.against.empty())
    refuse_input("hyrax-sim report: --against: allowed for trajectories only (found " +
                 request.files.front() + ")");
  std::vector<ShownResult> results;
  for (const std::string& path : request.files) {
    if (!holds_results(path))
      refuse_input(path + ": is not a file of a study or a sweep, as " + request.files.front() +
                   " is; a page shows either trajectories or these");
    results.push_back(result_of_file(core, path));
  }
  write_result_page(request.output, request.command, results);
  return !std::ranges::all_of(results, &Json::is_null, &ShownResult::members);
}

// The page says so, too: it is written all the same. That of another core replays nothing.
void require_core_of_page(const Core& core, const std::string& output) {
  if (!is_paper_model(core.name)) return;
  const std::string own = hex(fingerprint_of(core));
  if (page_core_fingerprint() == own) return;
  throw Failure(ExitCode::program_fault,
                output + ": replays another core than this program's (found fingerprint " +
                    std::string(page_core_fingerprint()) + "; this program's is " + own +
                    "): the page was not built again after the core changed; to do so: tools/run SCENARIO "
                    "--report FILE.html, or cmake --build DIR --target page, then cmake --build DIR");
}

}  // namespace

void write_report(const Core& core, const ReportRequest& request) {
  if (holds_results(request.files.front())) {
    if (write_results(core, request)) require_core_of_page(core, request.output);
    return;
  }
  const Json data = report_data(core, request);  // First: a bad input is reported by any build.
  write_page_file(request.output, PageKind::runs, data, still_html(request, data));
  require_core_of_page(core, request.output);
}

}  // namespace hyrax
