// Where the matched ODE of an arc meets the walls, as its frames go by.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "sim/motion/state.h"
#include "sim/reference/arc_cutter.h"
#include "sim/reference/flight.h"

namespace hyrax {

/// hyrax::time_of_impact, or another solution of the same.
using ImpactFinder = std::function<std::optional<Impact>(const Approach& approach, double t_max_s)>;

/// Keeps the last state of the arc and, for each wall, the first time at which the flight went out
/// through it, solved with the drag rate of the frame in which that happened. Along an axis it happens
/// once at most: horizontal speed keeps its sign, and vertical speed turns once, downwards.
class WallWatch {
 public:
  /// @param gravity_px_per_s2, log_air_drag of the matched ODE, whose rate is -log_air_drag / dt.
  WallWatch(double gravity_px_per_s2, double log_air_drag, ImpactFinder find)
      : gravity_(gravity_px_per_s2), log_air_drag_(log_air_drag), find_(std::move(find)) {}

  void start(const ArcStart& start);
  /// The matched ODE came to `now` in a frame of dt.
  void add(const Flight& now, double dt_s, double elapsed_s) {
    if (dt_s > 0.0) {
      if (is_any_outside_ || is_out(now) || may_touch_top(now, dt_s)) look(now, dt_s);
      rate_dt_s_ = dt_s;
    }
    last_ = now;
    last_elapsed_s_ = elapsed_s;
  }

  /// The impact on `wall`; its time counts from the arc's last row and is negative before it. Past
  /// that row the flight goes on with the rate of the last frame of positive dt, or of `clamped_dt_s`
  /// where there is none, for as long as `time_max_s` says.
  [[nodiscard]] std::optional<Impact> impact(Wall wall, double clamped_dt_s) const;
  /// How long past the last row a crossing still counts: the clamped frame and two frames of the rate.
  [[nodiscard]] double time_max_s(double clamped_dt_s) const {
    return clamped_dt_s + 2.0 * rate_dt_s(clamped_dt_s);
  }

 private:
  [[nodiscard]] bool is_out(const Flight& at) const {
    return at.dy_px > bottom_px_ || at.dy_px < top_px_ || at.dx_px > right_px_ || at.dx_px < left_px_;
  }
  // In the frame in which it turns downwards it can reach the top between two rows.
  [[nodiscard]] bool may_touch_top(const Flight& now, double dt_s) const {
    return last_.vy_px_per_s < 0.0 && now.vy_px_per_s >= 0.0 &&
           last_.dy_px + last_.vy_px_per_s * dt_s < top_px_;
  }
  [[nodiscard]] double rate_dt_s(double clamped_dt_s) const {
    return rate_dt_s_ > 0.0 ? rate_dt_s_ : clamped_dt_s;
  }
  void look(const Flight& now, double dt_s);
  [[nodiscard]] Approach approach(Wall wall, const Flight& from, double dt_s) const;
  [[nodiscard]] std::optional<Impact> find(Wall wall, double dt_s, double t_max_s) const;

  double gravity_;
  double log_air_drag_;
  ImpactFinder find_;
  double left_px_ = 0.0;  // Bounds, seen from the arc's first position.
  double right_px_ = 0.0;
  double top_px_ = 0.0;
  double bottom_px_ = 0.0;
  Flight last_;
  double last_elapsed_s_ = 0.0;
  double rate_dt_s_ = 0.0;            // Of the last frame in which time passed.
  std::array<bool, 4> is_outside_{};  // At the end of that frame.
  bool is_any_outside_ = false;
  std::array<std::optional<Impact>, 4> met_;
};

}  // namespace hyrax
