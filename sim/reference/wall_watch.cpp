#include "sim/reference/wall_watch.h"

namespace hyrax {
namespace {

// A frame's end is looked at by another form of the solution; rounding must not hide a wall that
// is met just there.
constexpr double kPastFrameEnd = 1.01;
constexpr double kFramesAfter = 2.0;

}  // namespace

void WallWatch::start(const ArcStart& start) {
  left_px_ = 0.0 - start.row.x_px;
  right_px_ = start.right_px - start.row.x_px;
  top_px_ = 0.0 - start.row.y_px;
  bottom_px_ = start.bottom_px - start.row.y_px;
  last_ = {0.0, 0.0, start.row.vx_px_per_s, start.row.vy_px_per_s};
  last_elapsed_s_ = 0.0;
  rate_dt_s_ = 0.0;
  met_ = {};
}

void WallWatch::look(double dt_s) {
  for (const Wall wall : kWalls) {
    std::optional<Impact>& met = met_[wall_index(wall)];
    if (met) continue;
    met = time_of_impact(approach(wall, dt_s), kPastFrameEnd * dt_s);
    if (met) met->t_s += last_elapsed_s_;
  }
}

std::optional<Impact> WallWatch::impact(Wall wall, double clamped_dt_s) const {
  if (std::optional<Impact> met = met_[wall_index(wall)]) {
    met->t_s -= last_elapsed_s_;
    return met;
  }
  const double dt_s = rate_dt_s_ > 0.0 ? rate_dt_s_ : clamped_dt_s;
  if (!(dt_s > 0.0)) return std::nullopt;
  return time_of_impact(approach(wall, dt_s), clamped_dt_s + kFramesAfter * dt_s);
}

Approach WallWatch::approach(Wall wall, double dt_s) const {
  const double rate = -log_air_drag_ / dt_s;
  switch (wall) {
    case Wall::left:
      return {left_px_ - last_.dx_px, -last_.vx_px_per_s, 0.0, rate};
    case Wall::right:
      return {last_.dx_px - right_px_, last_.vx_px_per_s, 0.0, rate};
    case Wall::top:
      return {top_px_ - last_.dy_px, -last_.vy_px_per_s, -gravity_, rate};
    case Wall::ground:
      return {last_.dy_px - bottom_px_, last_.vy_px_per_s, gravity_, rate};
  }
  return {};
}

}  // namespace hyrax
