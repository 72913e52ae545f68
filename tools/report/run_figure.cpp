#include "tools/report/run_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/columns.h"
#include "tools/files/non_finite_text.h"
#include "tools/report/figure_body.h"
#include "tools/report/figure_style.h"
#include "tools/report/gnuplot.h"
#include "tools/report/label_placer.h"
#include "tools/report/run_plot.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

std::string rate(const Clock& clock) {
  std::string text = "recorded frames";
  if (const auto* const fixed = std::get_if<FixedRate>(&clock.base))
    text = fmt::format("{:.6g} Hz", fixed->rate_hz);
  if (const auto* const fixed = std::get_if<FixedStep>(&clock.base))
    text = fmt::format("dt {:.6g} s", fixed->dt_s);
  return clock.jitter ? text + " with jitter" : text;
}

std::string sides(const Size& size) { return fmt::format("{} × {} px", size.width_px, size.height_px); }

bool is_outside(const std::optional<Box>& sprite, const Box& view) {
  return sprite && !view.holds(sprite->left_px, sprite->top_px);
}

std::string place(const Box& sprite) {
  return fmt::format("x {:.7g}, y {:.7g} px", sprite.left_px, sprite.top_px);
}

// How far it is from x, y along dx, dy (a direction of length 1) to the edge of the plot.
double distance_to_edge(const RunPlot& plot, double x, double y, double dx, double dy) {
  const double to_x = (dx > 0 ? RunPlot::kLeft + RunPlot::kWidth : RunPlot::kLeft) - x;
  const double to_y = (dy > 0 ? RunPlot::kTop + plot.height : RunPlot::kTop) - y;
  return std::min(dx == 0 ? HUGE_VAL : to_x / dx, dy == 0 ? HUGE_VAL : to_y / dy);
}

// Its length shows the speed, within limits, so that it neither vanishes nor covers the picture.
std::pair<double, double> arrow_span(const RunPlot& plot, const Throw& one, double speed_px_per_s_max) {
  constexpr double kLengthMin = 28;
  constexpr double kLengthMax = 112;
  const double speed = speed_px_per_s(one.velocity);
  const double dx = one.velocity.vx_px_per_s / speed, dy = one.velocity.vy_px_per_s / speed;
  const double x = plot.x(one.x_px), y = plot.y(one.y_px);
  const double length = kLengthMin + (kLengthMax - kLengthMin) * std::min(1.0, speed / speed_px_per_s_max);
  const double shown = std::max(kLengthMin, std::min(length, distance_to_edge(plot, x, y, dx, dy)));
  return {shown * dx, shown * dy};
}

std::string arrows(const RunPlot& plot, const RunScene& scene) {
  std::string commands;
  for (const Throw& one : scene.throws) {
    const auto [dx, dy] = arrow_span(plot, one, scene.path.speed_px_per_s_max);
    commands += arrow(plot.canvas, plot.x(one.x_px), plot.y(one.y_px), dx, dy);
  }
  return commands;
}

using Point = LabelPlacer::Point;

std::string label_at(const RunPlot& plot, std::string_view text, Point centre) {
  return fmt::format("set label {} at {} center front font ',12' tc rgb '{}'\n", in_quotes(text),
                     screen(plot.canvas, centre.x, centre.y), style::kInk);
}

// Inside the sprite's outline if the label fits, else beside it.
std::string caption(LabelPlacer& placer, const RunPlot& plot, const std::optional<Box>& sprite,
                    std::string_view label) {
  constexpr double kLine = 9;
  if (!sprite || is_outside(sprite, plot.view)) return "";
  const double left = plot.x(sprite->left_px), right = plot.x(sprite->right_px);
  const double top = plot.y(sprite->top_px), bottom = plot.y(sprite->bottom_px);
  const double x = (left + right) / 2, y = (top + bottom) / 2, half = LabelPlacer::width(label) / 2 + 2;
  std::vector<Point> centres;
  if (right - left >= 2 * half && bottom - top >= 4 * kLine)
    centres = {{x, bottom - kLine}, {x, top + kLine}};
  centres.insert(centres.end(), {{x, top - kLine}, {x, bottom + kLine}, {left - half, y}, {right + half, y}});
  return label_at(plot, label, placer.place(label, centres));
}

std::string captions(LabelPlacer& placer, const RunPlot& plot, const RunScene& scene) {
  if (scene.start && scene.end && nearly_cover(*scene.start, *scene.end, 0.5))
    return caption(placer, plot, scene.end, "start, end");
  return caption(placer, plot, scene.start, "start") + caption(placer, plot, scene.end, "end");
}

std::string times_of_inputs(LabelPlacer& placer, const RunPlot& plot, const RunScene& scene) {
  std::string commands;
  for (const TimedInput& input : scene.inputs) {
    const std::string label = fmt::format("{} {:.3g} s", input.what, input.t_s);
    const Point at{plot.x(input.x_px), plot.y(input.y_px)};
    commands += label_at(plot, label, placer.place(label, LabelPlacer::centres_around(at, label)));
  }
  return commands;
}

std::string not_finite(LabelPlacer& placer, const RunPlot& plot, const RunScene& scene) {
  if (!scene.not_finite) return "";
  constexpr std::string_view kLabel = "not finite";
  const Point at{plot.x(scene.not_finite->x_px), plot.y(scene.not_finite->y_px)};
  return label_at(plot, kLabel, placer.place(kLabel, LabelPlacer::centres_around(at, kLabel)));
}

LabelPlacer placer_of(const RunPlot& plot, const RunScene& scene) {
  LabelPlacer placer(
      {RunPlot::kLeft, RunPlot::kTop, RunPlot::kLeft + RunPlot::kWidth, RunPlot::kTop + plot.height});
  for (const Stroke& stroke : scene.path.strokes)
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
      placer.avoid({plot.x(stroke.points[i - 1].x_px), plot.y(stroke.points[i - 1].y_px)},
                   {plot.x(stroke.points[i].x_px), plot.y(stroke.points[i].y_px)});
  for (const Throw& one : scene.throws) {
    const auto [dx, dy] = arrow_span(plot, one, scene.path.speed_px_per_s_max);
    placer.avoid({plot.x(one.x_px), plot.y(one.y_px)}, {plot.x(one.x_px) + dx, plot.y(one.y_px) + dy});
  }
  if (scene.not_finite) {
    constexpr double kArm = 10;
    const double x = plot.x(scene.not_finite->x_px), y = plot.y(scene.not_finite->y_px);
    for (const double side : {-kArm, kArm}) placer.avoid({x - kArm, y - side}, {x + kArm, y + side});
  }
  for (const std::optional<Box>& sprite : {scene.start, scene.end}) {
    if (!sprite) continue;
    const double left = plot.x(sprite->left_px), right = plot.x(sprite->right_px);
    for (const double y : {plot.y(sprite->top_px), plot.y(sprite->bottom_px)})
      placer.avoid({left, y}, {right, y});
    for (const double x : {left, right})
      placer.avoid({x, plot.y(sprite->top_px)}, {x, plot.y(sprite->bottom_px)});
  }
  for (const Size& window : scene.windows) {
    const Point corner{plot.x(window.width_px), plot.y(window.height_px)};
    placer.avoid({corner.x, plot.y(0)}, corner);
    placer.avoid({plot.x(0), corner.y}, corner);
  }
  return placer;
}

// "600 steps · 10 s · 60 Hz · window 1920 × 1080 px · sprite 128 × 128 px".
std::string run_subtitle(const Scenario& scenario, const Columns& rows) {
  const std::int64_t steps = rows.size() == 0 ? 0 : rows.step.back();
  return fmt::format("{} {}  ·  {:.6g} s  ·  {}  ·  window {}  ·  sprite {}", steps,
                     steps == 1 ? "step" : "steps", rows.size() == 0 ? 0.0 : rows.t_s.back(),
                     rate(scenario.clock), sides(scenario.window), sides(scenario.sprite));
}

// A note on what the picture does not show; empty if it shows all.
std::string run_note(const Scenario& scenario, const Columns& rows, const RunScene& scene) {
  const std::int64_t steps = step_count(scenario);
  if (rows.size() > 0)
    if (const std::string text = non_finite_text(scenario, rows.row(rows.size() - 1)); !text.empty())
      return text;
  if (scene.path.cut_at_s) return fmt::format("path drawn up to {:.4g} s", *scene.path.cut_at_s);
  if (rows.size() > 0 && rows.step.back() < steps)
    return fmt::format("the first {} of {} steps", rows.step.back(), steps);
  if (is_outside(scene.start, scene.view)) return "starts far outside, at " + place(*scene.start);
  if (is_outside(scene.end, scene.view)) return "ends far outside, at " + place(*scene.end);
  return "";
}

// The commands that draw the labels of start, end and inputs, and the arrows of the throws.
std::string run_labels(const RunPlot& plot, const RunScene& scene) {
  LabelPlacer placer = placer_of(plot, scene);
  const std::string labels =
      captions(placer, plot, scene) + not_finite(placer, plot, scene) + times_of_inputs(placer, plot, scene);
  return arrows(plot, scene) + labels;
}

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
