#include "tools/report/run_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "tools/report/figure_body.h"
#include "tools/report/figure_style.h"
#include "tools/report/gnuplot.h"
#include "tools/report/run_labels.h"
#include "tools/report/run_plot.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

std::string block(std::string_view name, std::string_view lines) {
  return fmt::format("${} << EOD\n{}EOD\n", name, lines.empty() ? "NaN NaN NaN\n" : lines);
}

std::string point(double x_px, double y_px) { return fmt::format("{:.7g} {:.7g}\n", x_px, y_px); }

// Zero has no logarithm.
std::string point(const PathPoint& at, const RunPath& path) {
  return fmt::format("{:.7g} {:.7g} {:.4g}\n", at.x_px, at.y_px,
                     std::max(at.speed_px_per_s, path.speed_px_per_s_low));
}

std::string rectangle(const Size& window) {
  const double right_px = window.width_px;
  const double bottom_px = window.height_px;
  return point(0, 0) + point(right_px, 0) + point(right_px, bottom_px) + point(0, bottom_px) + point(0, 0) +
         "\n";
}

// A sprite's outline with round corners, so that it is not taken for a window.
std::string outline(const Box& box, const Box& view) {
  constexpr int kPointsPerCorner = 5;
  const double radius_px = std::min(0.18 * std::min(box.width_px(), box.height_px()),
                                    0.015 * std::max(view.width_px(), view.height_px()));
  const double left_px = box.left_px + radius_px, right_px = box.right_px - radius_px;
  const double top_px = box.top_px + radius_px, bottom_px = box.bottom_px - radius_px;
  const std::array<std::array<double, 2>, 4> centres = {
      {{right_px, bottom_px}, {left_px, bottom_px}, {left_px, top_px}, {right_px, top_px}}};
  std::string lines;
  for (std::size_t corner = 0; corner < centres.size(); ++corner)
    for (int i = 0; i <= kPointsPerCorner; ++i) {
      const double quarters = static_cast<double>(corner) + static_cast<double>(i) / kPointsPerCorner;
      const double angle = std::numbers::pi / 2 * quarters;
      lines += point(centres[corner][0] + radius_px * std::cos(angle),
                     centres[corner][1] + radius_px * std::sin(angle));
    }
  return lines + lines.substr(0, lines.find('\n') + 1) + "\n";
}

std::string outline(const std::optional<Box>& box, const Box& view) { return box ? outline(*box, view) : ""; }

std::string touching_side(const Bounce& bounce) {
  const Box& box = bounce.sprite;
  switch (bounce.wall) {
    case Wall::left:
      return point(box.left_px, box.top_px) + point(box.left_px, box.bottom_px) + "\n";
    case Wall::right:
      return point(box.right_px, box.top_px) + point(box.right_px, box.bottom_px) + "\n";
    case Wall::top:
      return point(box.left_px, box.top_px) + point(box.right_px, box.top_px) + "\n";
    case Wall::ground:
      return point(box.left_px, box.bottom_px) + point(box.right_px, box.bottom_px) + "\n";
  }
  return "";
}

std::string strokes(const RunPath& path, StrokeKind kind) {
  std::string lines;
  for (const Stroke& stroke : path.strokes) {
    if (stroke.kind != kind) continue;
    for (const PathPoint& at : stroke.points) lines += point(at, path);
    lines += "\n";
  }
  return lines;
}

// All windows share their upper left corner: of a later one only what the earlier ones do not show.
std::string windows(const RunScene& scene) {
  double widest_px = scene.windows.front().width_px, highest_px = scene.windows.front().height_px;
  std::string later;
  for (std::size_t i = 1; i < scene.windows.size(); ++i) {
    const double right_px = scene.windows[i].width_px, bottom_px = scene.windows[i].height_px;
    later += point(std::min(right_px, widest_px), 0) + point(right_px, 0) + point(right_px, bottom_px) +
             point(0, bottom_px) + point(0, std::min(bottom_px, highest_px)) + "\n";
    widest_px = std::max(widest_px, right_px);
    highest_px = std::max(highest_px, bottom_px);
  }
  return block("window", rectangle(scene.windows.front())) + block("later_windows", later);
}

std::string bounces(const RunScene& scene) {
  std::string ghosts;
  std::array<std::string, 4> sides, dots;
  // Contacts at rest would pile up: one dot for those that nearly cover one another.
  const double apart_px = std::max(scene.view.width_px(), scene.view.height_px()) / 80;
  std::vector<std::pair<Wall, PathPoint>> drawn;
  for (const Bounce& bounce : scene.bounces) {
    const Box& box = bounce.sprite;
    sides[wall_index(bounce.wall)] += touching_side(bounce);
    const PathPoint centre{(box.left_px + box.right_px) / 2, (box.top_px + box.bottom_px) / 2, 0.0};
    const auto covers = [&](const std::pair<Wall, PathPoint>& other) {
      return other.first == bounce.wall &&
             std::hypot(other.second.x_px - centre.x_px, other.second.y_px - centre.y_px) < apart_px;
    };
    if (std::any_of(drawn.begin(), drawn.end(), covers)) continue;
    drawn.emplace_back(bounce.wall, centre);
    dots[wall_index(bounce.wall)] += point(centre.x_px, centre.y_px);
  }
  for (const Box& ghost : scene.ghosts) ghosts += outline(ghost, scene.view);
  std::string blocks = block("ghosts", ghosts);
  for (std::size_t i = 0; i < kWalls.size(); ++i)
    blocks += block(fmt::format("{}_sides", kWallNames[i]), sides[i]) +
              block(fmt::format("{}_dots", kWallNames[i]), dots[i]);
  return blocks;
}

// The data blocks $window, $later_windows, $ghosts, $start, $end, $moved, $unrecorded (x and y in px), $flown
// and $beads (x, y in px, speed in px/s), and for each wall $WALL_sides, where the sprite touched it, and
// $WALL_dots, where its centre was. A blank line ends an outline or a line.
std::string run_data(const RunScene& scene) {
  std::string beads;
  for (const PathPoint& bead : scene.path.beads) beads += point(bead, scene.path);
  return windows(scene) + bounces(scene) + block("start", outline(scene.start, scene.view)) +
         block("end", outline(scene.end, scene.view)) +
         block("flown", strokes(scene.path, StrokeKind::flown)) +
         block("moved", strokes(scene.path, StrokeKind::moved)) +
         block("unrecorded", strokes(scene.path, StrokeKind::unrecorded)) + block("beads", beads) +
         (scene.not_finite ? block("not_finite", point(scene.not_finite->x_px, scene.not_finite->y_px)) : "");
}

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
          kWallNames[i], colour_of(kWallTones[i]), style::kPaper);
  if (scene.not_finite)
    command +=
        fmt::format(", $not_finite title 'not finite' with points pt 2 ps 2 lc rgb '{}'", style::kVermilion);
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
