#include "tools/app/report/report_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/app/command_line/shell_command.h"
#include "tools/app/sweep/member_result.h"
#include "tools/files/failure.h"
#include "tools/report/page_file.h"
#include "tools/report/run_scene.h"
#include "tools/store/ensemble_file.h"
#include "tools/store/table_file.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

void write_sweeps(const Core& core, const ReportRequest& request) {
  const std::vector<ShownResult> results = shown_sweeps(
      request.files, request.against, [&](const std::string& path) { return sweep_result(core, path); });
  write_result_page(request.output, request.command, results);
}

// The window with the path of the sprite's centre, to scale.
Sheet picture(const TrajectoryFile& file) {
  constexpr std::int64_t kRowsDrawn = 50'000;
  return run_panel(file.head().scenario, file.rows(0, std::min(file.row_count(), kRowsDrawn)),
                   file.contacts());
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

std::vector<RunPanel> panels_of(const ReportRequest& request, const Json& data) {
  std::vector<RunPanel> panels;
  for (std::size_t index = 0; request.files.size() > 1 && index < request.files.size(); ++index) {
    const Json& run = (*data.get<Json::Array>("runs"))[index];
    const Json* const golden = run.find("golden");
    std::string status = text_at(*run.find("result"), "status");
    if (golden != nullptr && !is_true(*golden, "agrees")) status = "disagreed";
    if (golden != nullptr && status == "played") status = "agreed";
    panels.push_back({.name = text_at(run, "name"),
                      .status = std::move(status),
                      .picture = picture(TrajectoryFile::open(request.files[index])),
                      .link = fmt::format("#run={}", index)});
  }
  return panels;
}

}  // namespace

std::string still_html(const ReportRequest& request, const Json& data) {
  std::string html;
  const auto& runs = *data.get<Json::Array>("runs");
  for (std::size_t index = 0; index < runs.size(); ++index)
    html += fmt::format("<section id=\"run={}\">\n", index) + html_line("h1", text_at(runs[index], "name")) +
            html_line("p", text_at(runs[index], "title")) + verdict(runs[index]) + "</section>\n";
  if (runs.size() > 1) return html;
  const Sheet sheet = picture(TrajectoryFile::open(request.files.front()));
  const std::string svg = svg_element("The window to scale, with the path of the hyrax", "", sheet, 0.0);
  return html + svg + "<style>" + dark_rules(svg) + "</style>\n";
}

void write_report(const Core& core, const ReportRequest& request) {
  const std::string& first = request.files.front();
  const std::string format = format_of_file(first);
  if (format == kStudyFormat)
    refuse_input(first + ": is a file of a study; its page: " +
                 program_command({"study", "NAME", "--report", "FILE.html"}));
  if (format == kEnsembleFormat) return write_sweeps(core, request);
  const Json data = report_data(core, request);  // First: a bad input is reported by any build.
  const std::vector<RunPanel> panels = request.panels.empty() ? panels_of(request, data) : request.panels;
  write_page_file(request.output, PageKind::runs, data, still_html(request, data),
                  panels.empty() ? "" : contact_sheet_html(panels, true));
}

}  // namespace hyrax
