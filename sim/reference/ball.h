// Numbers that are known to lie within a radius of a midpoint: rigorous bounds with 100 bits to spare.
//
// Source: S. M. Rump, "Fast and parallel interval arithmetic", BIT 39:534-554, 1999, with double-double
// midpoints (double_double.h, whose bounds of rounding are used doubled).
#pragma once

#include <cassert>
#include <cmath>

#include "sim/reference/double_double.h"
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

}  // namespace hyrax
