#include "sim/reference/arc_meter.h"

#include <algorithm>

namespace hyrax {

void WallWatch::start(const ArcStart& start) {
  for (const Wall wall : kWalls)
    at_px_[wall_index(wall)] =
        place_px(wall, start.bounds) - (is_at_side(wall) ? start.row.x_px : start.row.y_px);
  last_ = {0.0, 0.0, start.row.vx_px_per_s, start.row.vy_px_per_s};
  last_elapsed_s_ = 0.0;
  rate_dt_s_ = 0.0;
  met_ = {};
  is_any_outside_ = is_out(last_);
  for (const Wall wall : kWalls) is_outside_[wall_index(wall)] = approach(wall, last_, 1.0).position_px > 0.0;
}

// The rows' own positions decide in which frame a wall is crossed, so that each crossing is in one frame
// and in no other: the solution inside the frame may differ from them by rounding.
void WallWatch::look(const State& now, double dt_s) {
  for (const Wall wall : kWalls) {
    const std::size_t index = wall_index(wall);
    const Approach end = approach(wall, now, dt_s);
    const bool ends_outside = end.position_px > 0.0;
    // Only the top can be left and met again within a frame.
    if (!met_[index] && (ends_outside || wall == Wall::top)) {
      std::optional<Impact>& met = met_[index] = find(wall, dt_s, dt_s);
      if (!met && ends_outside && !is_outside_[index])
        met = Impact{dt_s, end.speed_px_per_s, end.drag_rate_per_s};
      if (met) met->t_s += last_elapsed_s_;
    }
    is_outside_[index] = ends_outside;
  }
  is_any_outside_ = is_out(now);
}

std::optional<Impact> WallWatch::impact(Wall wall, double clamped_dt_s) const {
  if (std::optional<Impact> met = met_[wall_index(wall)]) {
    met->t_s -= last_elapsed_s_;
    return met;
  }
  const double dt_s = rate_dt_s(clamped_dt_s);
  if (!(dt_s > 0.0)) return std::nullopt;
  return find(wall, dt_s, time_max_s(clamped_dt_s));
}

// From the last state on, at the rate of dt_s.
std::optional<Impact> WallWatch::find(Wall wall, double dt_s, double t_max_s) const {
  Approach from_last = approach(wall, last_, dt_s);
  if (!is_outside_[wall_index(wall)]) from_last.position_px = std::min(from_last.position_px, 0.0);
  return find_(from_last, t_max_s);
}

Approach WallWatch::approach(Wall wall, const State& from, double dt_s) const {
  constexpr double kRateMax_per_s = 1e300;  // Where a frame is subnormal its rate may overflow.
  return approach_to(wall, at_px_[wall_index(wall)], from, gravity_,
                     std::min(-log_air_drag_ / dt_s, kRateMax_per_s));
}

}  // namespace hyrax
