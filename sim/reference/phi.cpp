#include "sim/reference/phi.h"

#include <cmath>

namespace hyrax {
namespace {

constexpr double kSeriesReach = 0.25;
// From here on e^z is less than a unit in the last place of phi1, phi2 and 1 + z phi1.
constexpr double kExponentialGone = -45.0;
constexpr double kWideEpsilon = 1e-33;

// phi2(z) = sum z^n / (n + 2)!; the first term left out is 2.5e-18 of the sum at |z| = 1/4.
double phi2_series(double z) {
  constexpr double c[] = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                          1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                          1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800.0};
  // Estrin's scheme: half as long a chain of dependent operations as Horner's.
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double low = (c[0] + c[1] * z) + (c[2] + c[3] * z) * z2;
  const double middle = (c[4] + c[5] * z) + (c[6] + c[7] * z) * z2;
  const double high = (c[8] + c[9] * z) + (c[10] + c[11] * z) * z2;
  return low + z4 * (middle + z4 * high);
}

// phi1(2z) = phi1(z) (1 + e^z) / 2 and phi2(2z) = (phi1(z)^2 + 2 phi2(z)) / 4: only sums of
// positive numbers, so that a doubling adds a rounding or two and magnifies none.
template <class Number>
Phi<Number> doubled(Phi<Number> p, Number z, int doublings) {
  for (; doublings > 0; --doublings) {
    p = {p.one * ((z * p.one) * 0.5 + 1.0), p.one * p.one * 0.25 + p.two * 0.5};
    z = z * 2.0;
  }
  return p;
}

}  // namespace

Phi<double> phi(double z) {
  if (z < kExponentialGone) {
    const double one = -1.0 / z;
    return {one, (one - 1.0) / z};
  }
  int doublings = 0;
  while (z < -kSeriesReach) {
    z *= 0.5;
    ++doublings;
  }
  const double two = phi2_series(z);
  return doubled(Phi<double>{1.0 + z * two, two}, z, doublings);
}

Phi<DoubleDouble> wide_phi(DoubleDouble z) {
  int doublings = 0;
  while (z.hi < -1.0) {
    z = z * 0.5;
    ++doublings;
  }
  DoubleDouble term{0.5, 0.0};
  DoubleDouble two = term;
  for (int n = 1; std::fabs(term.hi) > kWideEpsilon; ++n) {
    term = term * z / (n + 2.0);
    two = two + term;
  }
  return doubled(Phi<DoubleDouble>{z * two + 1.0, two}, z, doublings);
}

// ln a = -2 artanh q with q = (1 - a) / (1 + a); 1 - a is exact for these a.
DoubleDouble wide_log(double a) {
  const DoubleDouble below = two_sum(1.0, -a);
  const DoubleDouble above = two_sum(1.0, a);
  const double q_hi = below.hi / above.hi;
  const DoubleDouble rest = below + -(above * q_hi);
  const DoubleDouble q = fast_two_sum(q_hi, (rest.hi + rest.lo) / above.hi);
  const DoubleDouble q2 = q * q;
  DoubleDouble power = q;
  DoubleDouble sum = q;
  for (int n = 3; std::fabs(power.hi) > kWideEpsilon * q.hi; n += 2) {
    power = power * q2;
    sum = sum + power / n;
  }
  return sum * -2.0;
}

}  // namespace hyrax
