#include "sim/compare/overlay.h"

#include <algorithm>
#include <cmath>

#include "sim/compare/run_distance.h"

namespace hyrax {
namespace {

constexpr double kVisible_px = 0.01;  // Smaller distances are drawn on a logarithmic axis.

Series path(const std::string& name, const Look& look) { return {.name = name, .look = look}; }

// Distances of very different size, and zeros among them.
Axis distance_axis(const std::vector<double>& distances_px) {
  double largest_px = 0.0;
  double smallest_px = 0.0;
  for (const double px : distances_px) {
    if (px > largest_px) largest_px = px;
    if (px > 0.0 && (smallest_px == 0.0 || px < smallest_px)) smallest_px = px;
  }
  Axis axis{.label = "distance (px)"};
  if (largest_px == 0.0 || largest_px >= kVisible_px) {
    axis.low = 0.0;
    return axis;
  }
  axis.is_logarithmic = true;
  axis.zero_at = smallest_px / 10.0;
  return axis;
}

}  // namespace

void Overlay::add(const Row& a, const Row& b) {
  if (!is_finite(state_of(a)) || !is_finite(state_of(b)) || !std::isfinite(a.t_s)) return;
  const Pair pair{a.t_s, {a.x_px, a.y_px}, {b.x_px, b.y_px}, distance_px(state_of(a), state_of(b))};
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

std::vector<Overlay::Pair> Overlay::pairs() const {
  std::vector<Pair> pairs = kept_;
  if (seen_ > 0) pairs.push_back(farthest_);
  return pairs;
}

Figure Overlay::figure(const Texts& texts) const {
  const Look look_a{.tone = Tone::blue, .width_px = 4.0};
  const Look look_b{.tone = Tone::vermilion, .width_px = 1.5};
  Series a = path(texts.a, look_a);
  Series b = path(texts.b, look_b);
  Series distance{.name = "distance", .look = {.tone = Tone::ink, .width_px = 1.5}};
  for (const Pair& pair : pairs()) {
    a.x.push_back(pair.a.x_px);
    a.y.push_back(pair.a.y_px);
    b.x.push_back(pair.b.x_px);
    b.y.push_back(pair.b.y_px);
    distance.x.push_back(pair.t_s);
    distance.y.push_back(pair.px);
  }
  Plot paths{.x = {.label = "x (px)"},
             .y = {.label = "y (px)", .is_reversed = true},
             .series = {std::move(a), std::move(b)},
             .has_equal_scales = true};
  Plot over_time{.x = {.label = "time (s)"}, .y = distance_axis(distance.y), .series = {std::move(distance)}};
  return {.title = texts.title,
          .subtitle = texts.subtitle,
          .body = std::vector<Plot>{std::move(paths), std::move(over_time)},
          .legend = {{texts.a, look_a}, {texts.b, look_b}}};
}

}  // namespace hyrax
