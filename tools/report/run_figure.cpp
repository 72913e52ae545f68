#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/files/non_finite_text.h"
#include "tools/report/contact_sheet.h"
#include "tools/report/figure_body.h"
#include "tools/report/label_placer.h"
#include "tools/report/plot_scale.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

std::string rate(const Clock& clock) {
  std::string text = "recorded frames";
  if (const auto* const fixed = std::get_if<FixedRate>(&clock.base))
    text = rounded(fixed->rate_hz, 6) + " Hz";
  if (const auto* const fixed = std::get_if<FixedStep>(&clock.base))
    text = "dt " + rounded(fixed->dt_s, 6) + " s";
  return clock.jitter ? text + " with jitter" : text;
}

std::string sides(const Size& size) { return fmt::format("{} × {} px", size.width_px, size.height_px); }

bool is_outside(const std::optional<Box>& sprite, const Box& view) {
  return sprite && !view.holds(sprite->left, sprite->top);
}

std::string place(const Box& sprite) {
  return fmt::format("x {}, y {} px", rounded(sprite.left, 7), rounded(sprite.top, 7));
}

// "600 steps · 10 s · 60 Hz · window 1920 × 1080 px · sprite 128 × 128 px".
std::string run_subtitle(const Scenario& scenario, const Columns& rows) {
  const std::int64_t steps = rows.size() == 0 ? 0 : rows.step.back();
  return fmt::format("{} · {} s · {} · window {} · sprite {}", counted(steps, "step"),
                     rounded(rows.size() == 0 ? 0.0 : rows.t_s.back(), 6), rate(scenario.clock),
                     sides(scenario.window), sides(scenario.sprite));
}

// A note on what the picture does not show; empty if it shows all.
std::string run_note(const Scenario& scenario, const Columns& rows, const RunScene& scene) {
  const std::int64_t steps = step_count(scenario);
  if (rows.size() > 0)
    if (const std::string text = non_finite_text(scenario, rows.row(rows.size() - 1)); !text.empty())
      return text;
  if (scene.path.cut_at_s) return fmt::format("path drawn up to {} s", rounded(*scene.path.cut_at_s));
  if (rows.size() > 0 && rows.step.back() < steps)
    return fmt::format("the first {} of {} steps", rows.step.back(), steps);
  if (is_outside(scene.start, scene.view)) return "starts far outside, at " + place(*scene.start);
  if (is_outside(scene.end, scene.view)) return "ends far outside, at " + place(*scene.end);
  return "";
}

// One sheet with the scene on it.
class RunDrawing {
 public:
  static constexpr double kWidth = 960.0;  // All in px of the SVG.
  static constexpr double kNarrow = 420.0;
  static constexpr double kLeft = 62.0;   // Room for the ticks of y,
  static constexpr double kRight = 86.0;  // for the scale of speeds,
  static constexpr double kBelow = 30.0;  // and for the ticks of x.

  RunDrawing(const Scenario& scenario, const Columns& rows, const RunScene& scene)
      : scenario_(scenario), rows_(rows), scene_(scene) {}

  /// @param height of the sheet, or 0: as high as the scene needs.
  [[nodiscard]] Sheet sheet(double width, double height) {
    Svg head, scratch;
    is_narrow_ = height > 0.0;
    const double left = is_narrow_ ? kLeft - 14 : kLeft;
    const double top =
        draw_head(head, width, scenario_.name, is_narrow_ ? std::string() : run_subtitle(scenario_, rows_),
                  run_note(scenario_, rows_, scene_), Tone::vermilion) +
        14;
    const double legend_height = draw_legend(scratch, legend(), width, 0.0);
    const double below = kBelow + legend_height + 16;
    const Box& view = scene_.view;
    const double room = width - left - kRight;
    const double height_max = height > 0.0 ? height - top - below : kPlotHeightMax;
    scale_ = std::min(room / view.width(), height_max / view.height());
    const double shown = std::max(view.height() * scale_, height > 0.0 ? height_max : kPlotHeightMin);
    room_ = {left, top, left + room, top + shown};
    plot_ = {left, room_.bottom - view.height() * scale_, left + view.width() * scale_, room_.bottom};
    Sheet sheet{width, height > 0.0 ? height : room_.bottom + below, std::move(head)};
    draw(sheet.svg);
    draw_legend(sheet.svg, legend(), width, room_.bottom + kBelow);
    return sheet;
  }

  /// The scene alone.
  [[nodiscard]] Sheet panel(double width, double height) {
    is_narrow_ = is_panel_ = true;
    const Box& view = scene_.view;
    scale_ = std::min(width / view.width(), height / view.height());
    plot_ = {0.0, 0.0, view.width() * scale_, view.height() * scale_};
    Sheet sheet{plot_.right, plot_.bottom};
    draw_scene(sheet.svg, plot_);
    return sheet;
  }

 private:
  [[nodiscard]] SvgPoint at(double x_px, double y_px) const {
    return {plot_.left + (x_px - scene_.view.left) * scale_, plot_.top + (y_px - scene_.view.top) * scale_};
  }
  [[nodiscard]] Box at(const Box& box) const {
    const SvgPoint low = at(box.left, box.top), high = at(box.right, box.bottom);
    return {low.x, low.y, high.x, high.y};
  }
  [[nodiscard]] Box at(const Size& window) const {
    return at(Box{0.0, 0.0, static_cast<double>(window.width_px), static_cast<double>(window.height_px)});
  }

  void draw(Svg& svg) {
    draw_axes(svg);
    draw_scene(svg, {plot_.left - 2, plot_.top - 2, plot_.right + 2, plot_.bottom + 2});
    draw_speeds(svg);
    LabelPlacer placer({room_.left, room_.top, room_.right, room_.bottom});
    avoid_all(placer);
    draw_throws(svg, placer);
    draw_labels(svg, placer);
  }

  void draw_scene(Svg& svg, const Box& clip) const {
    svg.begin_clip(clip);
    draw_windows(svg);
    draw_sprites(svg);
    draw_path(svg);
    draw_touches(svg);
    svg.end_clip();
  }

  // Ticks within the windows only.
  void draw_axes(Svg& svg) const {
    double right_px = 0.0, bottom_px = 0.0;
    for (const Size& window : scene_.windows) {
      right_px = std::max(right_px, static_cast<double>(window.width_px));
      bottom_px = std::max(bottom_px, static_cast<double>(window.height_px));
    }
    const auto draw_ticks = [&](double low, double high, double apart, const auto& draw_one) {
      const Axis axis{.low = std::max(low, 0.0), .high = high};
      PlotScale ticks(axis, {});
      const double length = (axis.high - axis.low) * scale_;
      ticks.place(0.0, length, std::max(kTick + 3, std::min(apart, length / 2)));
      for (const Tick& tick : ticks.ticks()) draw_one(tick);
    };
    double end = -HUGE_VAL;
    draw_ticks(scene_.view.left, std::min(right_px, scene_.view.right), 75.0, [&](const Tick& tick) {
      const double x = at(tick.at, 0.0).x, half = text_width(tick.text, kTick) / 2;
      if (x - half < end + 6) return;
      end = x + half;
      svg.line({{x, plot_.bottom + 3}, {x, plot_.bottom + 7}}, {colour_of(Tone::faint), 1.0});
      svg.text({x, plot_.bottom + 16}, tick.text, {.size = kTick, .side = Side::middle});
    });
    draw_ticks(scene_.view.top, std::min(bottom_px, scene_.view.bottom), 45.0, [&](const Tick& tick) {
      const double y = at(0.0, tick.at).y;
      svg.line({{plot_.left - 7, y}, {plot_.left - 3, y}}, {colour_of(Tone::faint), 1.0});
      svg.text({plot_.left - 11, y}, tick.text, {.size = kTick, .side = Side::right});
    });
    svg.text({plot_.left - 11, plot_.bottom + 16}, "px", {.size = kTick, .side = Side::right});
  }

  // All windows share their upper left corner.
  void draw_windows(Svg& svg) const {
    svg.begin("window");
    svg.box(at(scene_.windows.front()), colour_named("screen"));
    for (std::size_t i = 1; i < scene_.windows.size(); ++i)
      svg.outline(at(scene_.windows[i]), {colour_of(Tone::quiet), 1.25, Dash::long_dashes});
    svg.outline(at(scene_.windows.front()), {colour_of(Tone::ink), 1.5});
    svg.end();
  }

  // Round corners, so that an outline is not taken for a window.
  [[nodiscard]] static double corner_of(const Box& box) {
    return std::min({0.18 * box.width(), 0.18 * box.height(), 12.0});
  }

  void draw_sprites(Svg& svg) const {
    svg.begin("sprite at contacts");
    for (const Box& ghost : scene_.ghosts) {
      svg.box(at(ghost), colour_of(Tone::faint), corner_of(at(ghost)), 0.12);
      svg.outline(at(ghost), {colour_of(Tone::faint), 1.0}, corner_of(at(ghost)));
    }
    svg.end();
    svg.begin("sprite at start and end");
    if (scene_.end) svg.box(at(*scene_.end), colour_of(Tone::hairline), corner_of(at(*scene_.end)));
    for (const std::optional<Box>& sprite : {scene_.start, scene_.end})
      if (sprite) svg.outline(at(*sprite), {colour_of(Tone::ink), 1.5}, corner_of(at(*sprite)));
    svg.end();
  }

  [[nodiscard]] double part_of(double speed) const {
    const RunPath& path = scene_.path;
    if (!(path.speed_px_per_s_max > 0.0)) return 0.0;
    const double low = path.speed_px_per_s_low;
    return low > 0.0 ? std::log(std::max(speed, low) / low) / std::log(path.speed_px_per_s_max / low)
                     : speed / path.speed_px_per_s_max;
  }

  // Pieces of one colour, each as long as it can be.
  void draw_flown(Svg& svg, const std::vector<PathPoint>& points) const {
    std::vector<SvgPoint> piece;
    const std::string* colour = nullptr;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const std::string& its = speed_colour(part_of(points[i].speed_px_per_s));
      if (&its != colour) {
        if (colour != nullptr) svg.line(piece, {*colour, 2.5});
        piece = {at(points[i - 1].x_px, points[i - 1].y_px)};
        colour = &its;
      }
      piece.push_back(at(points[i].x_px, points[i].y_px));
    }
    if (colour != nullptr) svg.line(piece, {*colour, 2.5});
  }

  void draw_path(Svg& svg) const {
    svg.begin("path of the centre");
    for (const Stroke& stroke : scene_.path.strokes)
      if (stroke.kind == StrokeKind::flown && is_panel_)  // Panels have no scale of speeds.
        svg.line(line_of(stroke), {colour_named("path"), 2.0});
      else if (stroke.kind == StrokeKind::flown)
        draw_flown(svg, stroke.points);
      else
        svg.line(line_of(stroke), {colour_of(Tone::quiet), 1.5, dash_of(stroke.kind)});
    for (const PathPoint& bead : is_narrow_ ? std::vector<PathPoint>() : scene_.path.beads)
      svg.sign(at(bead.x_px, bead.y_px), Marker::dot, 0.75, speed_colour(part_of(bead.speed_px_per_s)));
    if (scene_.not_finite)
      svg.cross(at(scene_.not_finite->x, scene_.not_finite->y), kArm, {colour_of(Tone::vermilion), 3.0});
    svg.end();
  }

  [[nodiscard]] static Dash dash_of(StrokeKind kind) {
    return kind == StrokeKind::moved ? Dash::short_dashes : Dash::dots;
  }

  [[nodiscard]] std::vector<SvgPoint> line_of(const Stroke& stroke) const {
    std::vector<SvgPoint> line;
    for (const PathPoint& point : stroke.points) line.push_back(at(point.x_px, point.y_px));
    return line;
  }

  // Where it touched the wall, and for a bounce a dot at the centre; in a corner each dot is nearer to its
  // wall.
  void draw_touches(Svg& svg) const {
    constexpr double kAside = 5.0;
    for (const Touch& touch : scene_.touches) {
      const auto has_place_of = [&](const Touch& other) {
        return other.wall != touch.wall && other.sprite.left == touch.sprite.left &&
               other.sprite.top == touch.sprite.top;
      };
      const bool is_corner = std::ranges::any_of(scene_.touches, has_place_of);
      const Box box = at(touch.sprite);
      const bool is_level = touch.wall == Wall::top || touch.wall == Wall::ground;
      const double toward = touch.wall == Wall::left || touch.wall == Wall::top ? -1.0 : 1.0;
      const double x = toward < 0 ? box.left : box.right, y = toward < 0 ? box.top : box.bottom;
      const std::string& colour = colour_of(kWallTones[wall_index(touch.wall)]);
      svg.begin(fmt::format("{}: {}", touch.is_resting ? "resting contact" : "bounce", name_of(touch.wall)));
      svg.line(is_level ? std::vector<SvgPoint>{{box.left, y}, {box.right, y}}
                        : std::vector<SvgPoint>{{x, box.top}, {x, box.bottom}},
               {colour, kTouch});
      const double aside = is_corner ? toward * kAside : 0.0;
      const SvgPoint dot{box.centre().x + (is_level ? 0.0 : aside),
                         box.centre().y + (is_level ? aside : 0.0)};
      if (!touch.is_resting) {
        const Marker marker = kWallMarkers[wall_index(touch.wall)];
        svg.sign(dot, Marker::dot, 1.5, colour_named("screen"));
        svg.sign(dot, marker, 1.1, colour);
      }
      svg.end();
    }
  }

  void draw_speeds(Svg& svg) const {
    constexpr double kBarWidth = 10.0, kSteps = 24.0;
    const RunPath& path = scene_.path;
    if (!(path.speed_px_per_s_max > 0.0)) return;
    const Box bar{room_.right + 14, room_.top + 24, room_.right + 14 + kBarWidth, room_.bottom};
    for (double step = 0.0; step < kSteps; step += 1.0)
      svg.box({bar.left, bar.bottom - (step + 1) / kSteps * bar.height(), bar.right,
               bar.bottom - step / kSteps * bar.height() + 0.5},
              speed_colour(step / (kSteps - 1)));
    const bool is_logarithmic = path.speed_px_per_s_low > 0.0;
    const Axis axis{
        .is_logarithmic = is_logarithmic, .low = path.speed_px_per_s_low, .high = path.speed_px_per_s_max};
    PlotScale scale(axis, {});
    scale.place(bar.bottom, bar.top, 40.0);
    for (const Tick& tick : scale.ticks())
      svg.text({bar.right + 5, scale.at(tick.at)}, tick.text, {.size = kTick});
    svg.text({room_.right + kRight - 8, room_.top + 4}, "speed, px/s", {.size = kTick, .side = Side::right});
  }

  void avoid_all(LabelPlacer& placer) const {
    for (const Stroke& stroke : scene_.path.strokes) placer.avoid_line(line_of(stroke));
    if (scene_.not_finite) {
      const auto [x, y] = at(scene_.not_finite->x, scene_.not_finite->y);
      for (const double side : {-kArm, kArm}) placer.avoid({x - kArm, y - side}, {x + kArm, y + side});
    }
    for (const std::optional<Box>& sprite : {scene_.start, scene_.end})
      if (sprite) placer.avoid_outline(at(*sprite));
    for (const Size& window : scene_.windows) placer.avoid_outline(at(window));
  }

  // Short, and beside the path: behind the sprite, or at one of its sides.
  void draw_throws(Svg& svg, LabelPlacer& placer) const {
    constexpr double kLengthMin = 20.0, kLengthMax = 44.0, kAside = 9.0, kInto = 4.0;
    for (const Throw& one : scene_.throws) {
      const double speed = std::hypot(one.velocity.vx_px_per_s, one.velocity.vy_px_per_s);
      const double dx = one.velocity.vx_px_per_s / speed, dy = one.velocity.vy_px_per_s / speed;
      const double length =
          kLengthMin + (kLengthMax - kLengthMin) * std::min(1.0, speed / scene_.path.speed_px_per_s_max);
      const SvgPoint centre = at(one.x_px, one.y_px);
      const auto arrow_from = [&](double along, double aside) {
        const SvgPoint from{centre.x + along * dx - aside * dy, centre.y + along * dy + aside * dx};
        return std::pair(from, SvgPoint{from.x + length * dx, from.y + length * dy});
      };
      const std::array candidates = {arrow_from(-length - kInto, 0.0), arrow_from(0.0, kAside),
                                     arrow_from(0.0, -kAside), arrow_from(-length - kInto, kAside),
                                     arrow_from(-length - kInto, -kAside)};
      const auto cost = [&](const std::pair<SvgPoint, SvgPoint>& arrow) {
        double sum = placer.covered_by(arrow.first, arrow.second);
        for (const SvgPoint& end : {arrow.first, arrow.second})
          if (end.x < plot_.left || end.x > plot_.right || end.y < plot_.top || end.y > plot_.bottom)
            sum += 1e4;
        return sum;
      };
      const auto [from, to] = *std::ranges::min_element(candidates, {}, cost);
      svg.arrow(from, to, colour_of(Tone::ink));
      placer.avoid(from, to);
      if (scene_.throws.size() == 1) placer.draw_beside(svg, from, rounded(speed) + " px/s", Tone::ink);
    }
  }

  // Inside the sprite's outline if the label fits, else beside it.
  void draw_caption(Svg& svg, LabelPlacer& placer, const std::optional<Box>& sprite,
                    std::string_view label) const {
    constexpr double kLine = 9.0;
    if (!sprite || is_outside(sprite, scene_.view)) return;
    const Box box = at(*sprite);
    const auto [x, y] = box.centre();
    const double half = LabelPlacer::width(label) / 2 + 2;
    std::vector<SvgPoint> centres;
    if (box.width() >= 2 * half && box.height() >= 4 * kLine)
      centres = {{x, box.bottom - kLine}, {x, box.top + kLine}};
    centres.insert(
        centres.end(),
        {{x, box.top - kLine}, {x, box.bottom + kLine}, {box.left - half, y}, {box.right + half, y}});
    svg.text(placer.place(label, centres), label, LabelPlacer::lettering(Tone::ink));
  }

  void draw_labels(Svg& svg, LabelPlacer& placer) const {
    if (scene_.start && scene_.end && nearly_cover(*scene_.start, *scene_.end, 0.5)) {
      draw_caption(svg, placer, scene_.end, "start, end");
    } else {
      draw_caption(svg, placer, scene_.start, "start");
      draw_caption(svg, placer, scene_.end, "end");
    }
    if (scene_.not_finite)
      placer.draw_beside(svg, at(scene_.not_finite->x, scene_.not_finite->y), "not finite", Tone::ink);
    for (const TimedInput& input : scene_.inputs) {
      const SvgPoint place = at(input.x_px, input.y_px);
      svg.sign(place, Marker::ring, 1.0, colour_of(Tone::ink));
      placer.draw_beside(svg, place, fmt::format("{} {} s", input.what, rounded(input.t_s, 3)), Tone::ink);
    }
  }

  // Entries only for what the picture shows.
  [[nodiscard]] std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> entries;
    for (const Wall wall : kWalls)
      if (const std::int64_t count = scene_.bounces[wall]; count > 0)
        entries.push_back({fmt::format("{} {}", name_of(wall), with_decimals(static_cast<double>(count), 0)),
                           {.form = Form::points,
                            .tone = kWallTones[wall_index(wall)],
                            .marker = kWallMarkers[wall_index(wall)],
                            .marker_size = 1.1}});
    if (!entries.empty()) entries.front().text = "bounces: " + entries.front().text;
    if (std::ranges::any_of(scene_.touches, &Touch::is_resting))
      entries.push_back(
          {"resting contact", {.tone = kWallTones[wall_index(Wall::ground)], .width_px = kTouch}});
    const auto has = [this](StrokeKind kind) {
      return std::ranges::any_of(scene_.path.strokes,
                                 [kind](const Stroke& stroke) { return stroke.kind == kind; });
    };
    const auto add_line = [&](const char* text, Dash dash) {
      entries.push_back({text, {.tone = Tone::quiet, .width_px = 1.5, .dash = dash}});
    };
    if (has(StrokeKind::moved)) add_line("not flown", dash_of(StrokeKind::moved));
    if (has(StrokeKind::unrecorded)) add_line("not recorded", dash_of(StrokeKind::unrecorded));
    if (scene_.windows.size() > 1) add_line("resized window", Dash::long_dashes);
    if (!scene_.path.beads.empty() && !is_narrow_)
      entries.push_back({scene_.path.frames_per_bead == 1
                             ? "every frame"
                             : fmt::format("every {} frames", scene_.path.frames_per_bead),
                         {.form = Form::points, .tone = Tone::green, .marker_size = 0.75}});
    return entries;
  }

  static constexpr double kPlotHeightMax = 600.0;
  static constexpr double kPlotHeightMin = 220.0;
  static constexpr double kTick = 12.0;  // Of letters.
  static constexpr double kArm = 10.0;   // Of the cross.
  static constexpr double kTouch = 5.0;  // Width of a wall where it was touched.

  const Scenario& scenario_;
  const Columns& rows_;
  const RunScene& scene_;
  bool is_narrow_ = false;
  bool is_panel_ = false;
  double scale_ = 0.0;  // px of the SVG for one px of the window, in x and in y.
  Box room_;            // For the plot and its labels.
  Box plot_;            // What shows the view.
};

constexpr double kDetail_px = 1.25;  // What is smaller, a path need not show.

}  // namespace

std::string run_svg(const Scenario& scenario, const Columns& rows, const std::vector<Contact>& contacts,
                    const std::optional<WallCounts>& bounces) {
  RunScene scene = make_run_scene(scenario, rows, contacts,
                                  (RunDrawing::kWidth - RunDrawing::kLeft - RunDrawing::kRight) / kDetail_px);
  if (bounces) scene.bounces = *bounces;
  RunDrawing drawing(scenario, rows, scene);
  const Sheet wide = drawing.sheet(RunDrawing::kWidth, 0.0);
  const Sheet narrow =
      drawing.sheet(RunDrawing::kNarrow, RunDrawing::kNarrow / RunDrawing::kWidth * wide.height);
  return svg_text(scenario.name, wide, &narrow);
}

Sheet run_panel(const Scenario& scenario, const Columns& rows, const std::vector<Contact>& contacts) {
  const RunScene scene = make_run_scene(scenario, rows, contacts, kPanelWidth / kDetail_px);
  return RunDrawing(scenario, rows, scene).panel(kPanelWidth, kPanelHeight);
}

}  // namespace hyrax
