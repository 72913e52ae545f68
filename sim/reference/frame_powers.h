// What n equal frames make of a flight, by the closed forms, for n = 0, 1, 2, ...
#pragma once

#include <cstddef>
#include <vector>

#include "sim/reference/double_double.h"
#include "sim/reference/model.h"

namespace hyrax {

/// The closed forms have one shape. After n frames of dt = h from speed v, with acceleration g,
///   speed = power v + g h sum,   displacement = h (sum v + g h sum_of_sums).
template <class Number>
struct FramePower {
  Number power{};
  Number sum{};
  Number sum_of_sums{};
};

/// Coefficients of the forms for one drag factor a, to 100 bits, and rounded.
///
/// Discrete, what the paper's step does exactly: power = a^n, sum = S_n = a (1 - a^n) / (1 - a),
/// sum_of_sums = a (n - S_n) / (1 - a); by the recurrences S_n+1 = a (1 + S_n) and
/// Q_n+1 = Q_n + S_n+1, which cancel nothing and hold for a = 1 as well.
///
/// Matched, the ODE v' = g - k v with k = -ln(a) / h: z = -k n h = n ln(a), so that
/// power = e^z, sum = n phi1(z), sum_of_sums = n^2 phi2(z) do not depend on h; by the flow of one
/// frame, composed n times.
///
/// Exact law, the ODE whose flow over a frame is the paper's step: v' = kappa g - k v, y' = kappa v + eta
/// with kappa = -a ln(a) / (1 - a) and eta = shift g h, shift = a - kappa^2 phi2(ln a). Over n frames
/// power = e^z, sum = kappa n phi1(z), sum_of_sums = kappa^2 n^2 phi2(z) + shift n, from z and e^z - 1 at
/// once: the flows of single frames, composed, would be the discrete forms whatever phi1 and phi2 were, and
/// a run could not differ from its law. To 75 bits. Source: the modified equation of backward error analysis
/// (E. Hairer, C. Lubich, G. Wanner, "Geometric Numerical Integration", 2nd ed., 2006, chapter IX), for this
/// linear step a closed form.
class FramePowers {
 public:
  /// A longer run of equal frames is cut in pieces of this length.
  static constexpr std::size_t kFramesMax = 128;

  /// REQUIRES: 0.5 <= model.air_drag <= 1.
  explicit FramePowers(const Model& model);

  /// REQUIRES: n <= kFramesMax, and reach(n) was called.
  [[nodiscard]] const FramePower<double>& discrete(std::size_t n) const { return rounded_[n].discrete; }
  [[nodiscard]] const FramePower<double>& matched(std::size_t n) const { return rounded_[n].matched; }
  [[nodiscard]] const FramePower<double>& exact_law(std::size_t n) const { return rounded_[n].exact_law; }
  [[nodiscard]] const FramePower<DoubleDouble>& wide_discrete(std::size_t n) const {
    return wide_[n].discrete;
  }
  [[nodiscard]] const FramePower<DoubleDouble>& wide_matched(std::size_t n) const { return wide_[n].matched; }
  [[nodiscard]] const FramePower<DoubleDouble>& wide_exact_law(std::size_t n) const {
    return wide_[n].exact_law;
  }

  /// Makes the coefficients up to n.
  void reach(std::size_t n) {
    while (rounded_.size() <= n) extend();
  }

  /// ln(a); the matched drag rate of a frame is -ln(a) / dt.
  [[nodiscard]] double log_air_drag() const { return log_.hi; }
  /// eta / (g h) of the exact law [-]: 1/2 without drag.
  [[nodiscard]] double shift() const { return shift_.hi; }

 private:
  template <class Number>
  struct Forms {
    FramePower<Number> discrete;
    FramePower<Number> matched;
    FramePower<Number> exact_law;
  };
  void extend();
  [[nodiscard]] FramePower<DoubleDouble> exact_law_after(double frames, DoubleDouble power) const;
  void push(const Forms<DoubleDouble>& forms);

  double air_drag_;
  DoubleDouble log_;
  DoubleDouble phi1_;  // Of one frame.
  DoubleDouble phi2_;
  DoubleDouble kappa_;
  DoubleDouble kappa_by_log_;  // kappa / ln(a); not for a = 1.
  DoubleDouble shift_;
  std::vector<Forms<double>> rounded_;
  std::vector<Forms<DoubleDouble>> wide_;
};

}  // namespace hyrax
