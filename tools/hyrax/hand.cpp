#include "tools/hyrax/hand.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace hyrax {
namespace {

constexpr std::int64_t kSpansPerSecond = 10;  // 100 ms.
constexpr std::int64_t kShortestSpansPerSecond = 100;

double speed_px_per_s(std::int64_t distance_px, std::int64_t ticks_per_s, std::int64_t span_ticks) {
  return static_cast<double>(distance_px * ticks_per_s) / static_cast<double>(span_ticks);
}

}  // namespace

Hold::Hold(std::int64_t ticks_per_s, ScreenPoint hand, std::int64_t ticks, Position corner,
           ScreenPoint origin)
    : ticks_per_s_(ticks_per_s),
      grabbed_ticks_(ticks),
      samples_{{hand, ticks}},
      offset_{corner.x_px + (origin.x_px - hand.x_px), corner.y_px + (origin.y_px - hand.y_px)} {
  assert(ticks_per_s > 0);
}

bool Hold::move(ScreenPoint to, std::int64_t ticks) {
  if (to == samples_.back().at) return false;
  assert(ticks >= samples_.back().ticks);
  samples_.push_back({to, ticks});
  // The last sample before the span is the position at its beginning.
  const std::int64_t begin_ticks = ticks - ticks_per_s_ / kSpansPerSecond;
  while (samples_.size() > 1 && samples_[1].ticks <= begin_ticks) samples_.pop_front();
  return has_moved_ = true;
}

std::optional<Position> Hold::follow(ScreenPoint origin) {
  if (!std::exchange(has_moved_, false)) return std::nullopt;
  const ScreenPoint at = samples_.back().at;
  return Position{offset_.x_px + (at.x_px - origin.x_px), offset_.y_px + (at.y_px - origin.y_px)};
}

Velocity Hold::velocity(std::int64_t ticks) const {
  const std::int64_t longest_ticks = ticks_per_s_ / kSpansPerSecond;
  const std::int64_t shortest_ticks = std::max<std::int64_t>(ticks_per_s_ / kShortestSpansPerSecond, 1);
  const std::int64_t span_ticks = std::clamp(ticks - grabbed_ticks_, shortest_ticks, longest_ticks);
  const std::int64_t begin_ticks = ticks - span_ticks;
  ScreenPoint begin = samples_.front().at;
  for (const Sample& sample : samples_)
    if (sample.ticks <= begin_ticks) begin = sample.at;
  const ScreenPoint end = samples_.back().at;
  return {speed_px_per_s(std::int64_t{end.x_px} - begin.x_px, ticks_per_s_, span_ticks),
          speed_px_per_s(std::int64_t{end.y_px} - begin.y_px, ticks_per_s_, span_ticks)};
}

}  // namespace hyrax
