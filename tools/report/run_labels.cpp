#include "tools/report/run_labels.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/scenario/frame_clock.h"

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
double way_to_edge(const RunPlot& plot, double x, double y, double dx, double dy) {
  const double to_x = (dx > 0 ? RunPlot::kLeft + RunPlot::kWidth : RunPlot::kLeft) - x;
  const double to_y = (dy > 0 ? RunPlot::kTop + plot.height : RunPlot::kTop) - y;
  return std::min(dx == 0 ? HUGE_VAL : to_x / dx, dy == 0 ? HUGE_VAL : to_y / dy);
}

// Its length tells the speed, but it neither vanishes nor covers the picture.
std::string arrow_of(const RunPlot& plot, const Throw& one, double speed_px_per_s_max) {
  constexpr double kLengthMin = 28;
  constexpr double kLengthMax = 112;
  const double speed = speed_px_per_s(one.velocity);
  const double dx = one.velocity.vx_px_per_s / speed, dy = one.velocity.vy_px_per_s / speed;
  const double x = plot.x(one.x_px), y = plot.y(one.y_px);
  const double length = kLengthMin + (kLengthMax - kLengthMin) * std::min(1.0, speed / speed_px_per_s_max);
  const double shown = std::max(kLengthMin, std::min(length, way_to_edge(plot, x, y, dx, dy)));
  return arrow(plot.canvas, x, y, shown * dx, shown * dy);
}

std::string arrows(const RunPlot& plot, const RunScene& scene) {
  std::string commands;
  for (const Throw& one : scene.throws) commands += arrow_of(plot, one, scene.path.speed_px_per_s_max);
  return commands;
}

// A word inside the sprite's outline where it fits, else above it, or below where the top is near.
std::string caption(const RunPlot& plot, const std::optional<Box>& sprite, std::string_view word,
                    bool at_bottom) {
  constexpr double kLetter = 6.2;
  constexpr double kLine = 9;
  if (!sprite || is_outside(sprite, plot.view)) return "";
  const double top = plot.y(sprite->top_px), bottom = plot.y(sprite->bottom_px);
  const bool fits = std::min(sprite->width_px(), sprite->height_px()) * plot.scale >=
                    kLetter * static_cast<double>(word.size()) + kLine;
  double y = at_bottom ? bottom - kLine : top + kLine;
  if (!fits) y = top - kLine > RunPlot::kTop + 2 * kLine ? top - kLine : bottom + kLine;
  return fmt::format("set label {} at {} center front font ',12' tc rgb '{}'\n", quoted(word),
                     screen(plot.canvas, plot.x((sprite->left_px + sprite->right_px) / 2), y), style::kInk);
}

std::string captions(const RunPlot& plot, const RunScene& scene) {
  const bool is_at_bottom = !scene.starts_downwards;
  if (scene.start && scene.end && nearly_cover(*scene.start, *scene.end, 0.5))
    return caption(plot, scene.end, "start, end", is_at_bottom);
  return caption(plot, scene.start, "start", is_at_bottom) + caption(plot, scene.end, "end", true);
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
  if (scene.path.cut_at_s) return fmt::format("path drawn up to {:.4g} s", *scene.path.cut_at_s);
  if (rows.size() > 0 && rows.step.back() < steps)
    return fmt::format("the first {} of {} steps", rows.step.back(), steps);
  if (is_outside(scene.start, scene.view)) return "starts far outside, at " + place(*scene.start);
  if (is_outside(scene.end, scene.view)) return "ends far outside, at " + place(*scene.end);
  return "";
}

std::string run_labels(const RunPlot& plot, const RunScene& scene) {
  return arrows(plot, scene) + captions(plot, scene);
}

}  // namespace hyrax
