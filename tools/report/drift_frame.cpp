#include "tools/report/drift_frame.h"

#include <array>

#include <fmt/format.h>

#include "tools/report/run_legend.h"

namespace hyrax {
namespace {

constexpr Canvas kCanvas = {960, 460};
constexpr std::string_view kBand = "#eaeef2";
constexpr std::size_t kArcsMarkedMax = 80;

std::string note_of(const DriftPicture& picture) {
  if (picture.arcs.empty()) return "";
  const DriftSummary& summary = picture.summary;
  if (summary.arcs > static_cast<std::int64_t>(picture.arcs.size()))
    return fmt::format("the first {} of {} arcs", picture.arcs.size(), summary.arcs);
  return fmt::format("{} arc{}, {} contact{}", summary.arcs, summary.arcs == 1 ? "" : "s", summary.contacts,
                     summary.contacts == 1 ? "" : "s");
}

}  // namespace

std::string_view wall_colour(Wall wall) { return kWallColours[wall_index(wall)]; }

PlotFrame drift_frame(const DriftPicture& picture, std::string_view subtitle, std::string_view x_label,
                      std::string_view y_label) {
  PlotFrame frame(picture.scenario.name, subtitle, x_label, y_label, kCanvas);
  frame.note(note_of(picture));
  return frame;
}

void mark_arcs(PlotFrame& frame, const DriftPicture& picture) {
  const std::vector<ArcErrors>& arcs = picture.arcs;
  if (picture.rows.empty()) return frame.add("set xrange [0:1]\n");
  const double end_s = picture.rows.back().errors.t_s;
  frame.add(fmt::format("set xrange [0:{:.10g}]\n", end_s > 0.0 ? end_s : 1.0));
  if (arcs.size() > kArcsMarkedMax) return;
  std::array<bool, 4> has_wall{};
  std::size_t row = 0;
  for (std::size_t arc = 0; arc < arcs.size(); ++arc) {
    if (row == picture.rows.size()) break;
    const double from_s = picture.rows[row].errors.t_s;
    while (row < picture.rows.size() && picture.rows[row].arc == arc) ++row;
    const double to_s = picture.rows[row - (row > 0)].errors.t_s;
    if (arc % 2 == 1)
      frame.add(
          fmt::format("set object {} rectangle from first {:.10g}, graph 0 to first {:.10g}, graph 1 behind "
                      "fs solid 1 noborder fc rgb '{}'\n",
                      10 + arc, from_s, to_s, kBand));
    const auto wall = wall_of(arcs[arc].ended_by);
    if (!wall) continue;
    has_wall[wall_index(*wall)] = true;
    frame.add(fmt::format("set label '' at first {:.10g}, graph 1.035 point pt 7 ps 0.7 lc rgb '{}'\n", to_s,
                          wall_colour(*wall)));
  }
  if (arcs.size() > 1) frame.explain_area("every other arc", kBand);
  for (const Wall wall : kWalls)
    if (has_wall[wall_index(wall)]) frame.explain_dot(kWallNames[wall_index(wall)], wall_colour(wall));
}

}  // namespace hyrax
