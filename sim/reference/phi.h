// phi1(z) = (e^z - 1) / z and phi2(z) = (phi1(z) - 1) / z, without losing digits and without libm.
//
// With z = -k t they are what linear drag makes of a flight; the textbook form (1 - e^-kt) / k
// cancels as k -> 0. Source: M. Hochbruck, A. Ostermann, "Exponential integrators", Acta Numerica
// 19:209-286, 2010, equations 2.10 and 2.11.
#pragma once

#include "sim/reference/double_double.h"

namespace hyrax {

struct Phi {
  double one = 1.0;
  double two = 0.5;
};

/// Relative error of each below 1e-15. REQUIRES: z <= 0.
[[nodiscard]] Phi phi(double z);

struct WidePhi {
  DoubleDouble one{1.0, 0.0};
  DoubleDouble two{0.5, 0.0};
};

/// To 100 bits. REQUIRES: z <= 0.
[[nodiscard]] WidePhi wide_phi(DoubleDouble z);

/// Natural logarithm to 100 bits. REQUIRES: 0.5 <= a <= 1.
[[nodiscard]] DoubleDouble wide_log(double a);

}  // namespace hyrax
