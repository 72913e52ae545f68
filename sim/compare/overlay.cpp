#include "sim/compare/overlay.h"

#include <algorithm>
#include <cmath>

#include "sim/compare/run_distance.h"
#include "sim/result/number_text.h"

namespace hyrax {
namespace {

// Distances of very different size, and zeros among them.
Axis distance_axis(const std::vector<double>& distances_px) {
  double smallest_px = HUGE_VAL;
  for (const double px : distances_px)
    if (px > 0.0) smallest_px = std::min(smallest_px, px);
  return {.label = "distance, px", .is_logarithmic = true, .zero_at = smallest_px / 10.0};
}

// The outline of a sprite.
Series outline(const std::string& name, const Look& look, double left, double top, const Size& size) {
  const double right = left + size.width_px, bottom = top + size.height_px;
  return {.name = name,
          .look = look,
          .x = {left, right, right, left, left},
          .y = {top, top, bottom, bottom, top}};
}

}  // namespace

void Overlay::add(const Row& a, const Row& b) {
  if (!is_finite(state_of(a)) || !is_finite(state_of(b)) || !std::isfinite(a.t_s)) return;
  const Pair pair{a.t_s, {a.x_px, a.y_px}, {b.x_px, b.y_px}, distance_px(state_of(a), state_of(b))};
  if (!start_) start_ = pair;
  if (!first_difference_ && pair.px > 0.0) first_difference_ = pair;
  end_ = pair;
  if (seen_ == 0 || pair.px > farthest_.px) farthest_ = pair;
  if (++seen_ < stride_) return;
  kept_.push_back(farthest_);
  seen_ = 0;
  if (kept_.size() < kPairsMax) return;
  for (std::size_t index = 0; index < kPairsMax / 2; ++index)
    kept_[index] = std::max(kept_[2 * index], kept_[2 * index + 1],
                            [](const Pair& one, const Pair& other) { return one.px < other.px; });
  kept_.resize(kPairsMax / 2);
  stride_ *= 2;
}

Figure Overlay::figure(const Texts& texts) const {
  const auto centre = [&](const Position& corner) {
    return Position{corner.x_px + 0.5 * texts.sprite.width_px, corner.y_px + 0.5 * texts.sprite.height_px};
  };
  std::vector<Series> scene = {
      outline("window", {.tone = Tone::faint, .width_px = 1.0}, 0.0, 0.0, texts.window),
      {.name = texts.a, .look = {.tone = Tone::blue, .width_px = 4.0}},
      {.name = texts.b, .look = {.tone = Tone::vermilion, .width_px = 1.5}}};
  Series distance{.name = "distance", .look = {.tone = Tone::ink, .width_px = 1.5}};
  std::vector<Pair> pairs = kept_;
  if (seen_ > 0) pairs.push_back(farthest_);
  for (const Pair& pair : pairs) {
    const Position a = centre(pair.a), b = centre(pair.b);
    scene[1].x.push_back(a.x_px);
    scene[1].y.push_back(a.y_px);
    scene[2].x.push_back(b.x_px);
    scene[2].y.push_back(b.y_px);
    distance.x.push_back(pair.t_s);
    distance.y.push_back(pair.px);
  }
  const auto mark = [&](const std::string& name, const std::optional<Pair>& at, Marker marker) {
    Series points{.name = name, .look = {.form = Form::points, .marker = marker, .marker_size = 1.2}};
    if (!at) return;
    const Position a = centre(at->a), b = centre(at->b);
    points.x = {a.x_px, b.x_px};
    points.y = {a.y_px, b.y_px};
    scene.push_back(std::move(points));
  };
  mark("start", start_, Marker::ring);
  mark("first difference", first_difference_, Marker::square);
  mark("end", end_, Marker::dot);
  Figure figure{.title = texts.title, .subtitle = texts.subtitle};
  const Pair farthest =
      pairs.empty() ? Pair{} : *std::ranges::max_element(pairs, {}, [](const Pair& pair) { return pair.px; });
  for (const Series& series : scene) figure.legend.push_back({series.name, series.look});
  Plot over_time{.x = {.label = "time, s"},
                 .y = distance_axis(distance.y),
                 .when_empty = start_ ? "the same place at every time" : "no row is finite in both"};
  if (!first_difference_) distance.x = distance.y = {};
  over_time.series = {std::move(distance)};
  // As large as the window and what is drawn, unless that is very long or very high.
  const auto ends = [&](std::vector<double> Series::*values) {
    std::pair found(HUGE_VAL, -HUGE_VAL);
    for (const Series& series : scene)
      for (const double value : series.*values)
        found = {std::min(found.first, value), std::max(found.second, value)};
    return found;
  };
  auto [left, right] = ends(&Series::x);
  auto [top, bottom] = ends(&Series::y);
  double shape = (right - left) / (bottom - top);
  if (!(shape > 0.6 && shape < 4.0)) shape = 1.6, left = right = top = bottom = kNotGiven;
  std::vector<Plot> plots = {
      {.x = {.label = "x of the centre, px", .low = left, .high = right},
       .y = {.label = "y of the centre, px, downwards", .is_reversed = true, .low = top, .high = bottom},
       .series = scene,
       .has_equal_scales = true}};
  if (farthest.px > 0.0) {
    // Both sprites whole, or, of a small distance, their upper left corners.
    const double dx = farthest.b.x_px - farthest.a.x_px, dy = farthest.b.y_px - farthest.a.y_px;
    const double side_px = std::max(texts.sprite.width_px, texts.sprite.height_px);
    const bool is_whole = 4.0 * farthest.px > side_px;
    const double room = is_whole ? 0.7 * side_px : farthest.px,
                 x = 0.5 * dx + (is_whole ? 0.5 * side_px : 0.0);
    const double half = std::max(0.5 * std::fabs(dy) + room, (0.5 * std::fabs(dx) + room) / shape),
                 y = x + 0.5 * (dy - dx);
    plots.push_back({.x = {.label = "x from there, px", .low = x - shape * half, .high = x + shape * half},
                     .y = {.label = "farthest, at " + rounded(farthest.t_s) + " s: y from the corner of " +
                                    texts.a + ", px, downwards",
                           .is_reversed = true,
                           .low = y - half,
                           .high = y + half},
                     .series = {outline(texts.a, scene[1].look, 0.0, 0.0, texts.sprite),
                                outline(texts.b, scene[2].look, dx, dy, texts.sprite),
                                {.name = "largest distance",
                                 .look = {.form = Form::line_and_points, .width_px = 1.5, .marker_size = 0.8},
                                 .x = {0.0, dx},
                                 .y = {0.0, dy}}},
                     .texts = {{0.5 * dx, 0.5 * dy, rounded(farthest.px, 3) + " px", Tone::ink}},
                     .has_equal_scales = true});
  }
  plots.push_back(std::move(over_time));
  figure.body = std::move(plots);
  return figure;
}

}  // namespace hyrax
