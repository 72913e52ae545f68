// What must hold of speed against error whatever the machine: orders, rounding, and the figures of the
// paper's step. Never a time.
#pragma once

#include <string>
#include <vector>

#include "sim/study/speed_error/speed_error.h"

namespace hyrax {

/// A figure outside its bounds, both inclusive.
struct BrokenRule {
  std::string rule;   ///< What is held, in words.
  std::string where;  ///< Method, problem, rate.
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// 0. Every method plays every problem to its end, with finite errors.
/// 1. In free flight every convergent method's order can be fitted over three rates or more, and is the
///    analytic one, +- kOrderApart.
/// 2. The exact methods are there within rounding, at every rate.
/// 3. The paper's step does not converge: its error at the highest rate is above that at 60 Hz.
/// 4. Its distance from the fixed ODE, measured here, is that of sim/reference to 1e-6 of itself.
/// 5. Its truncation against the matched ODE is of first order, and that of its velocity is its closed form.
/// 6. The method of Prince and Dormand (rk8pd), where it was asked for 1e-10 or less, is there within 1e-6
/// px.
[[nodiscard]] std::vector<BrokenRule> broken_rules(const SpeedError& study);

/// An order is fitted over few points, the coarsest of which still feel the next term of the error.
inline constexpr double kOrderApart = 0.1;

}  // namespace hyrax
