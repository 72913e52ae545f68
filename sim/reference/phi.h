// phi1(z) = (e^z - 1) / z and phi2(z) = (phi1(z) - 1) / z, without losing digits and without libm.
//
// With z = -k t they are what linear drag makes of a flight; the textbook form (1 - e^-kt) / k
// cancels as k -> 0. Source: M. Hochbruck, A. Ostermann, "Exponential integrators", Acta Numerica
// 19:209-286, 2010, equations 2.10 and 2.11.
#pragma once

#include "sim/reference/double_double.h"

namespace hyrax {

template <class Number>
struct Phi {
  Number one;
  Number two;
};

/// Relative error of each below 1e-15. REQUIRES: z <= 0.
[[nodiscard]] Phi<double> phi(double z);

/// To 100 bits. REQUIRES: z <= 0.
[[nodiscard]] Phi<DoubleDouble> wide_phi(DoubleDouble z);

/// Natural logarithm to 100 bits. REQUIRES: 0.5 <= a <= 1.
[[nodiscard]] DoubleDouble wide_log(double a);

}  // namespace hyrax
