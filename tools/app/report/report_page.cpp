#include "tools/app/report/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/replay/fingerprint.h"
#include "sim/trajectory/physics_model.h"
#include "tools/files/failure.h"
#include "tools/report/page_file.h"
#include "tools/report/svg.h"
#include "tools/store/trajectory_file.h"

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

std::string line(std::string_view tag, std::string_view text) {
  return text.empty() ? "" : fmt::format("<{0}>{1}</{0}>\n", tag, escaped(text));
}

// Of the data that this program made.
const std::string& text_at(const Json& object, std::string_view key) { return *object.get<std::string>(key); }
bool is_true(const Json& object, std::string_view key) { return *object.get<bool>(key); }

std::string verdict(const Json& run) {
  std::string html = line("p", text_at(run, "cause"));
  if (const std::string where = text_at(run, "non_finite"); !where.empty())
    html += line("p", where + "; the run ended there");
  if (const Json* const golden = run.find("golden"))
    html +=
        line("p", is_true(*golden, "agrees") ? "Agrees with the golden file, bit for bit."
                                             : "Differs from the golden file: " + text_at(*golden, "class"));
  for (const Json& each : *run.get<Json::Array>("expect"))
    html += line("p", (is_true(each, "holds") ? "holds: " : "does not hold: ") + text_at(each, "text"));
  return html;
}

}  // namespace

std::string still_html(const ReportRequest& request, const Json& data) {
  std::string html;
  const auto& runs = *data.get<Json::Array>("runs");
  for (std::size_t index = 0; index < runs.size(); ++index) {
    const Json& run = runs[index];
    html += line("h1", text_at(run, "name")) + line("p", text_at(run, "title")) + verdict(run) +
            picture(TrajectoryFile::open(request.files[index]));
  }
  return html;
}

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
