#include "tools/report/run_labels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "sim/scenario/frame_clock.h"
#include "tools/files/non_finite_text.h"
#include "tools/report/label_placer.h"

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

}  // namespace

std::string run_subtitle(const Scenario& scenario, const Columns& rows) {
  const std::int64_t steps = rows.size() == 0 ? 0 : rows.step.back();
  return fmt::format("{} {}  ·  {:.6g} s  ·  {}  ·  window {}  ·  sprite {}", steps,
                     steps == 1 ? "step" : "steps", rows.size() == 0 ? 0.0 : rows.t_s.back(),
                     rate(scenario.clock), sides(scenario.window), sides(scenario.sprite));
}

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

std::string run_labels(const RunPlot& plot, const RunScene& scene) {
  LabelPlacer placer = placer_of(plot, scene);
  const std::string labels =
      captions(placer, plot, scene) + not_finite(placer, plot, scene) + times_of_inputs(placer, plot, scene);
  return arrows(plot, scene) + labels;
}

}  // namespace hyrax
