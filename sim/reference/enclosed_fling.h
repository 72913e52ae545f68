// Bounds within which the exact fling lies for certain.
#pragma once

#include <optional>
#include <string>

#include "sim/reference/ball.h"
#include "sim/reference/flight.h"
#include "sim/reference/model.h"

namespace hyrax {

/// A state within balls.
struct EnclosedState {
  EnclosedState() = default;
  explicit EnclosedState(const State& exact)
      : x_px(exact.x_px), y_px(exact.y_px), vx_px_per_s(exact.vx_px_per_s), vy_px_per_s(exact.vy_px_per_s) {}
  Ball x_px, y_px, vx_px_per_s, vy_px_per_s;
};

/// The fling of exact_fling.h, for the binary64 values of the constants. Each impact's time is a root that is
/// there for certain, and before every other wall's; where that cannot be decided, nothing is enclosed any
/// more.
///
/// Each axis flies from its own last impact, so that what is not known of an impact at a side, its time, is
/// none of the height's; they meet in the ground's friction alone. Else balls would grow by a factor a
/// bounce.
class EnclosedFling {
 public:
  explicit EnclosedFling(const Model& model);

  /// As ExactFling::start.
  void start(const EnclosedState& motion, const Bounds& bounds, bool slides);
  /// As ExactFling::at. Nothing where something cannot be decided.
  [[nodiscard]] std::optional<EnclosedState> at(double t_s);
  [[nodiscard]] bool slides() const { return slides_; }
  /// What cannot be decided; empty: nothing so far.
  [[nodiscard]] const std::string& why_not() const { return why_not_; }

 private:
  struct Motion {  // Along one axis.
    Ball position_px;
    Ball speed_px_per_s;
  };
  struct Axis {
    Motion from;  // At from_s.
    Ball from_s;
    double acceleration_px_per_s2 = 0.0;
  };
  [[nodiscard]] Ball rate_per_s() const {
    return slides_ ? drag_rate_per_s_ + friction_rate_per_s_ : drag_rate_per_s_;
  }
  [[nodiscard]] Axis& axis_of(Wall wall) { return is_at_side(wall) ? x_ : y_; }
  [[nodiscard]] Axis seen_from(Wall wall);
  [[nodiscard]] Motion after(const Axis& axis, const Ball& since_s) const;
  [[nodiscard]] std::optional<Ball> impact(const Axis& seen);
  [[nodiscard]] std::optional<Ball> enclosed_root(const Axis& seen, double near_s);
  [[nodiscard]] bool is_never_met(const Axis& seen) const;
  void find_next();
  void bounce(Wall wall, const Ball& t_s);
  void give_up(const char* why);

  Model model_;
  Ball drag_rate_per_s_;
  Ball friction_rate_per_s_;
  Bounds bounds_;
  Axis x_;
  Axis y_;
  std::optional<Ball> next_s_;
  Wall next_wall_ = Wall::ground;
  bool slides_ = false;
  int impacts_ = 0;
  std::string why_not_;
};

}  // namespace hyrax
