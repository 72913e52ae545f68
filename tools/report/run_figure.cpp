#include "tools/report/run_figure.h"

#include <fmt/format.h>

#include "tools/report/figure_style.h"
#include "tools/report/gnuplot.h"
#include "tools/report/run_data.h"
#include "tools/report/run_labels.h"
#include "tools/report/run_legend.h"
#include "tools/report/run_plot.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

constexpr double kDetail = 1.25;  // px of the SVG: what is smaller, the path need not show.

// What is drawn later covers what is drawn before.
std::string plot_command(const RunScene& scene) {
  std::string command = fmt::format(
      "plot $window title 'window' with filledcurves closed fs solid 1 noborder fc rgb '{paper}', "
      "$later_windows title 'later windows' with lines lw 1.5 dt (8,5) lc rgb '{quiet}', "
      "$window title 'window' with lines lw 1.5 lc rgb '{ink}', "
      "$ghosts title 'sprite at contacts' with filledcurves closed fs transparent solid 0.12 noborder fc rgb "
      "'{faint}', "
      "$ghosts title 'sprite at contacts' with lines lw 1 lc rgb '{faint}', "
      "$end title 'sprite at the end' with filledcurves closed fs solid 1 noborder fc rgb '{hairline}', "
      "$start title 'sprite at the start' with lines lw 1.5 lc rgb '{ink}', $end title 'sprite at the end' "
      "with lines lw 1.5 lc rgb '{ink}', "
      "$moved title 'not flown' with lines lw 1.5 dt {moved} lc rgb '{quiet}', $unrecorded title 'not "
      "recorded' with lines lw 1.5 dt {unrecorded} "
      "lc rgb '{quiet}', "
      "$flown title 'path of the centre' with lines lw 2.5 lc palette, $beads title 'steps at equal "
      "intervals' with points pt 7 ps 0.5 lc palette",
      fmt::arg("paper", style::kPaper), fmt::arg("ink", style::kInk), fmt::arg("quiet", style::kQuietInk),
      fmt::arg("faint", style::kFaintInk), fmt::arg("hairline", style::kHairline),
      fmt::arg("moved", kMovedDashes), fmt::arg("unrecorded", kUnrecordedDashes));
  for (std::size_t i = 0; i < kWalls.size(); ++i)
    if (scene.contacts[kWalls[i]] > 0)
      command += fmt::format(
          ", ${0}_sides title 'contacts: {0}' with lines lw 5 lc rgb '{1}', ${0}_dots title 'contacts: {0}' "
          "with points pt 7 ps 1.0 lc rgb '{2}', "
          "${0}_dots title 'contacts: {0}' with points pt 7 ps 0.7 lc rgb '{1}'",
          kWallNames[i], kWallColours[i], style::kPaper);
  return command + "\n";
}

}  // namespace

std::string run_figure_script(const Scenario& scenario, const Columns& rows,
                              const std::vector<Contact>& contacts,
                              const std::optional<WallCounts>& contacts_counted) {
  RunScene scene = make_run_scene(scenario, rows, contacts, RunPlot::kWidth / kDetail);
  if (contacts_counted) scene.contacts = *contacts_counted;
  const RunPlot plot(scene.view);
  return figure_head(plot.canvas, scenario.name, run_subtitle(scenario, rows),
                     run_note(scenario, rows, scene)) +
         run_axes(plot) + viridis() + run_colour_bar(plot, scene.path) + run_data(scene) +
         run_labels(plot, scene) + run_legend(plot, scene) + plot_command(scene);
}

void draw_run_figure(const std::string& path, const Scenario& scenario, const Columns& rows,
                     const std::vector<Contact>& contacts,
                     const std::optional<WallCounts>& contacts_counted) {
  draw_figure(path, run_figure_script(scenario, rows, contacts, contacts_counted));
}

}  // namespace hyrax
