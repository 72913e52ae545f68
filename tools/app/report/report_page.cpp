#include "tools/app/report/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/replay/fingerprint.h"
#include "sim/trajectory/physics_model.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/files/failure.h"
#include "tools/report/page_file.h"
#include "tools/store/ensemble_file.h"
#include "tools/store/table_file.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

// Whether the page replays what it shows.
bool write_sweeps(const Core& core, const ReportRequest& request) {
  if (!request.against.empty())
    refuse_input("hyrax-sim report: --against: allowed for trajectories only (found " +
                 request.files.front() + ")");
  std::vector<ShownResult> results;
  for (const std::string& path : request.files) {
    if (format_of_file(path) != kEnsembleFormat)
      refuse_input(path + ": is not a sweep's file, as " + request.files.front() +
                   " is; a page shows either trajectories or sweeps");
    results.push_back(sweep_result(core, path));
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

constexpr std::int64_t kPointsMax = 2'000;

// The window with the path of the sprite's centre, to scale.
std::string picture(const TrajectoryFile& file) {
  const Scenario& scenario = file.head().scenario;
  const Columns rows = file.rows(0, std::min<std::int64_t>(file.row_count(), kPointsMax));
  std::string points;
  for (std::size_t row = 0; row < rows.size() && std::isfinite(rows.x_px[row] + rows.y_px[row]); ++row)
    points += fmt::format("{:.1f},{:.1f} ", rows.x_px[row] + scenario.sprite.width_px / 2.0,
                          rows.y_px[row] + scenario.sprite.height_px / 2.0);
  return fmt::format(
      "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"The window to scale, with the path of the "
      "hyrax\">"
      "<rect width=\"100%\" height=\"100%\" fill=\"none\" stroke=\"currentColor\" "
      "vector-effect=\"non-scaling-stroke\"/>"
      "<polyline points=\"{}\" fill=\"none\" stroke=\"currentColor\" "
      "vector-effect=\"non-scaling-stroke\"/></svg>\n",
      std::max(scenario.window.width_px, 1), std::max(scenario.window.height_px, 1), points);
}

// Of the data that this program made.
const std::string& text_at(const Json& object, std::string_view key) { return *object.get<std::string>(key); }
bool is_true(const Json& object, std::string_view key) { return *object.get<bool>(key); }

std::string verdict(const Json& run) {
  std::string html;
  if (const std::string where = text_at(run, "non_finite"); !where.empty())
    html += html_line("p", where + "; the run ended there");
  if (const Json* const golden = run.find("golden"))
    html += html_line("p", is_true(*golden, "agrees")
                               ? "Agrees with the golden file, bit for bit."
                               : "Differs from the golden file: " + text_at(*golden, "class"));
  for (const Json& each : *run.get<Json::Array>("expect"))
    html += html_line("p", (is_true(each, "holds") ? "holds: " : "does not hold: ") + text_at(each, "text"));
  return html;
}

}  // namespace

std::string still_html(const ReportRequest& request, const Json& data) {
  std::string html;
  const auto& runs = *data.get<Json::Array>("runs");
  for (std::size_t index = 0; index < runs.size(); ++index) {
    const Json& run = runs[index];
    html += html_line("h1", text_at(run, "name")) + html_line("p", text_at(run, "title")) + verdict(run) +
            picture(TrajectoryFile::open(request.files[index]));
  }
  return html;
}

void write_report(const Core& core, const ReportRequest& request) {
  const std::string& first = request.files.front();
  const std::string format = format_of_file(first);
  if (format == kStudyFormat)
    refuse_input(first + ": is a file of a study; its page: " +
                 program_command({"study", "NAME", "--report", "FILE.html"}));
  if (format == kEnsembleFormat) {
    if (write_sweeps(core, request)) require_core_of_page(core, request.output);
    return;
  }
  const Json data = report_data(core, request);  // First: a bad input is reported by any build.
  write_page_file(request.output, PageKind::runs, data, still_html(request, data));
  require_core_of_page(core, request.output);
}

}  // namespace hyrax
