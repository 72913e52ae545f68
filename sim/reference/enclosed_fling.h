// Bounds within which the exact fling lies for certain.
#pragma once

#include <cassert>
#include <cmath>
#include <optional>
#include <string>

#include "sim/reference/double_double.h"
#include "sim/reference/flight.h"
#include "sim/reference/model.h"
#include "sim/reference/phi.h"

namespace hyrax {

/// Values are 0, or of magnitudes between 1e-200 and 1e200.
struct Ball {
  DoubleDouble mid;
  double radius = 0.0;

  constexpr Ball() = default;
  constexpr Ball(double exact) : mid{exact, 0.0} {}  // NOLINT: a double is a Ball.
  /// @param relative_error of the midpoint, besides the radius given.
  Ball(DoubleDouble middle, double off, double relative_error)
      : mid(middle), radius((off + relative_error * std::fabs(middle.hi)) * kUp) {}

  [[nodiscard]] bool is_exactly(double value) const {
    return radius == 0.0 && mid.hi == value && mid.lo == 0.0;
  }
  /// As doubles, rounded outwards.
  [[nodiscard]] double low() const { return mid.hi - reach(); }
  [[nodiscard]] double high() const { return mid.hi + reach(); }
  [[nodiscard]] double magnitude() const { return (std::fabs(mid.hi) + radius) * kUp; }

  // Radii are sums and products of a few positive numbers: each rounds up by less.
  static constexpr double kUp = 1.0 + 1e-14;
  static constexpr double kRounding = 0x1p-100;

 private:
  [[nodiscard]] double reach() const {
    return radius == 0.0 && mid.lo == 0.0 ? 0.0
                                          : (radius + std::fabs(mid.lo) + 0x1p-52 * std::fabs(mid.hi)) * kUp;
  }
};

inline Ball operator-(const Ball& a) { return {-a.mid, a.radius, 0.0}; }
inline Ball operator+(const Ball& a, const Ball& b) {
  const DoubleDouble sum = a.mid + b.mid;
  const bool is_exact = sum.hi == 0.0 || a.is_exactly(0.0) || b.is_exactly(0.0);
  return {sum, a.radius + b.radius, is_exact ? 0.0 : Ball::kRounding};
}
inline Ball operator-(const Ball& a, const Ball& b) { return a + -b; }
inline Ball operator*(const Ball& a, const Ball& b) {
  return {a.mid * b.mid, a.magnitude() * b.radius + std::fabs(b.mid.hi) * Ball::kUp * a.radius,
          Ball::kRounding};
}
/// REQUIRES: b is not 0.
inline Ball operator/(const Ball& a, const Ball& b) {
  const DoubleDouble quotient = a.mid / b.mid;
  const double least = std::fabs(b.mid.hi) / Ball::kUp - b.radius;
  assert(least > 0.0);
  return {quotient, (a.radius + std::fabs(quotient.hi) * Ball::kUp * b.radius) / least, Ball::kRounding};
}

/// For z <= 0 the slopes are the integrals of s e^sz and of s (1 - s) e^sz over 0 .. 1: at most 1/2 and 1/6,
/// and 1 / z^2. REQUIRES: z <= 0.
inline Phi<Ball> phi(const Ball& z) {
  constexpr double kDoublings = 0x1p-90;  // 66 of them, by less than 2^-97 each.
  const Phi<DoubleDouble> p = wide_phi(z.mid);
  const double least = std::fmax(0.0, std::fabs(z.mid.hi) / Ball::kUp - z.radius);
  const auto off = [&](double slope) { return std::fmin(slope, Ball::kUp / (least * least)) * z.radius; };
  return {{p.one, off(1.0 / 2.0), kDoublings}, {p.two, off(0.17), kDoublings}};
}

/// -ln(factor). REQUIRES: 0 < factor <= 1.
inline Ball minus_log(double factor) {
  double doublings = 0.0;
  for (; factor < 0.5; factor *= 2.0) doublings += 1.0;
  return Ball(wide_log(0.5) * -doublings + -wide_log(factor), 0.0, 0x1p-95);
}

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
  [[nodiscard]] std::optional<EnclosedState> at(const Ball& t_s);
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
