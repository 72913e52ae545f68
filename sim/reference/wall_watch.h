// Where the matched ODE of an arc meets the walls, as its frames go by.
#pragma once

#include <array>
#include <optional>

#include "sim/reference/arc_cutter.h"
#include "sim/reference/flight.h"
#include "sim/reference/impact.h"
#include "sim/trajectory/wall.h"

namespace hyrax {

/// Keeps the last two states of the arc and, for each wall, the first time at which the flight went
/// out through it. Along an axis that happens once at most: horizontal speed keeps its sign, and
/// vertical speed turns once, downwards.
class WallWatch {
 public:
  /// @param gravity_px_per_s2, log_air_drag of the matched ODE, whose rate is -log_air_drag / dt.
  WallWatch(double gravity_px_per_s2, double log_air_drag)
      : gravity_(gravity_px_per_s2), log_air_drag_(log_air_drag) {}

  void start(const ArcStart& start);
  /// The matched ODE came to `now` in a frame of dt.
  void see(const Flight& now, double dt_s, double elapsed_s) {
    if (dt_s > 0.0) {
      if (is_out(now) || may_touch_top(now, dt_s)) look(dt_s);
      rate_dt_s_ = dt_s;
    }
    last_ = now;
    last_elapsed_s_ = elapsed_s;
  }

  /// The impact on `wall`; its time counts from the arc's last row and is negative before it. The
  /// last frame's rate goes on up to two frames after a row that follows by `clamped_dt_s`.
  [[nodiscard]] std::optional<Impact> impact(Wall wall, double clamped_dt_s) const;

 private:
  [[nodiscard]] bool is_out(const Flight& at) const {
    return at.dy_px > bottom_px_ || at.dy_px < top_px_ || at.dx_px > right_px_ || at.dx_px < left_px_;
  }
  // In the frame in which it turns downwards it can reach the top between two rows.
  [[nodiscard]] bool may_touch_top(const Flight& now, double dt_s) const {
    return last_.vy_px_per_s < 0.0 && now.vy_px_per_s >= 0.0 &&
           last_.dy_px + last_.vy_px_per_s * dt_s < top_px_;
  }
  void look(double dt_s);
  [[nodiscard]] Approach approach(Wall wall, double dt_s) const;

  double gravity_;
  double log_air_drag_;
  double left_px_ = 0.0;  // Bounds, seen from the arc's first position.
  double right_px_ = 0.0;
  double top_px_ = 0.0;
  double bottom_px_ = 0.0;
  Flight last_;
  double last_elapsed_s_ = 0.0;
  double rate_dt_s_ = 0.0;  // Of the last frame in which time passed.
  std::array<std::optional<Impact>, 4> met_;
};

}  // namespace hyrax
