#include "tools/hyrax/hand.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace hyrax {
namespace {

constexpr std::int64_t kSpansPerSecond = 10;  // 100 ms.
constexpr std::int64_t kShortestSpansPerSecond = 100;

}  // namespace

Hold::Hold(std::int64_t ticks_per_s, ScreenPoint hand, std::int64_t ticks, Position corner,
           ScreenPoint origin)
    : ticks_per_s_(ticks_per_s),
      grabbed_at_(hand),
      samples_{{hand, ticks}},
      offset_{corner.x_px + (origin.x_px - hand.x_px), corner.y_px + (origin.y_px - hand.y_px)} {
  assert(ticks_per_s > 0);
}

bool Hold::move(ScreenPoint to, std::int64_t ticks) {
  if (to == samples_.back().at) return false;
  ticks = std::max(ticks, samples_.back().ticks);
  samples_.push_back({to, ticks});
  // The last sample before the span is the position at its beginning.
  const std::int64_t begin_ticks = ticks - ticks_per_s_ / kSpansPerSecond;
  while (samples_.size() > 1 && samples_[1].ticks <= begin_ticks) samples_.pop_front();
  return has_moved_ = true;
}

std::optional<Position> Hold::follow(ScreenPoint origin) {
  if (!std::exchange(has_moved_, false)) return std::nullopt;
  return corner_of(samples_.back().at, origin);
}

Velocity Hold::velocity(std::int64_t ticks) const {
  const std::int64_t longest_ticks = ticks_per_s_ / kSpansPerSecond;
  const std::int64_t shortest_ticks = std::max<std::int64_t>(ticks_per_s_ / kShortestSpansPerSecond, 1);
  const std::int64_t span_ticks = std::clamp(ticks - samples_.front().ticks, shortest_ticks, longest_ticks);
  const std::int64_t begin_ticks = ticks - span_ticks;
  const auto next = std::ranges::find_if(samples_, [&](const Sample& s) { return s.ticks > begin_ticks; });
  const Sample& before = next == samples_.begin() ? *next : *std::prev(next);
  const Sample& after = next == samples_.end() ? before : *next;
  const double part = before.ticks == after.ticks ? 0.0
                                                  : static_cast<double>(begin_ticks - before.ticks) /
                                                        static_cast<double>(after.ticks - before.ticks);
  const auto speed_px_per_s = [&](std::int32_t ScreenPoint::*side) {
    const double begin_px = before.at.*side + part * (after.at.*side - before.at.*side);
    return (samples_.back().at.*side - begin_px) * static_cast<double>(ticks_per_s_) /
           static_cast<double>(span_ticks);
  };
  return {speed_px_per_s(&ScreenPoint::x_px), speed_px_per_s(&ScreenPoint::y_px)};
}

}  // namespace hyrax
