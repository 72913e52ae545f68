#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/app/report/report_page.h"
#include "tools/report/page_file.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

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
  return text.empty() ? "" : fmt::format("<{0}>{1}</{0}>\n", tag, html_text(text));
}

std::string text_at(const Json& object, std::string_view key) {
  const auto* const text = object.get<std::string>(key);
  return text == nullptr ? "" : *text;
}

bool is_true(const Json& object, std::string_view key) {
  const bool* const value = object.get<bool>(key);
  return value != nullptr && *value;
}

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

}  // namespace hyrax
