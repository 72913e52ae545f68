#include "sim/reference/frame_powers.h"

#include <cassert>

#include "sim/reference/phi.h"

namespace hyrax {
namespace {

FramePower<double> rounded(const FramePower<DoubleDouble>& wide) {
  return {wide.power.hi, wide.sum.hi, wide.sum_of_sums.hi};
}

// To 100 bits.
DoubleDouble quotient(double a, DoubleDouble b) {
  const double first = a / b.hi;
  const DoubleDouble rest = -(b * first) + a;
  return fast_two_sum(first, (rest.hi + rest.lo) / b.hi);
}

}  // namespace

FramePowers::FramePowers(const Model& model) : air_drag_(model.air_drag), log_(wide_log(model.air_drag)) {
  assert(model.air_drag >= 0.5 && model.air_drag <= 1.0);
  const WidePhi frame = wide_phi(log_);
  phi1_ = frame.one;
  phi2_ = frame.two;
  kappa_ = quotient(model.air_drag, phi1_);  // -a ln(a) / (1 - a), for a = 1 as well.
  kappa_squared_ = kappa_ * kappa_;
  shift_ = -(kappa_squared_ * phi2_) + model.air_drag;
  rounded_.reserve(kFramesMax + 1);
  wide_.reserve(kFramesMax + 1);
  constexpr DoubleDouble kOne{1.0, 0.0};
  push({{kOne, {}, {}}, {kOne, {}, {}}, {kOne, {}, {}}});
}

void FramePowers::extend() {
  const Forms<DoubleDouble> last = wide_.back();
  Forms<DoubleDouble> next;
  next.discrete.power = last.discrete.power * air_drag_;
  next.discrete.sum = (last.discrete.sum + 1.0) * air_drag_;
  next.discrete.sum_of_sums = last.discrete.sum_of_sums + next.discrete.sum;
  // One frame from speed v: v -> a v + g h phi1, displacement h (phi1 v + g h phi2).
  next.matched.power = next.discrete.power;
  next.matched.sum = last.matched.sum * air_drag_ + phi1_;
  next.matched.sum_of_sums = last.matched.sum_of_sums + (last.matched.sum * phi1_ + phi2_);
  next.exact_law = exact_law_of(next.matched, static_cast<double>(wide_.size()));
  push(next);
}

FramePower<DoubleDouble> FramePowers::exact_law_of(const FramePower<DoubleDouble>& matched,
                                                   double frames) const {
  return {matched.power, kappa_ * matched.sum, kappa_squared_ * matched.sum_of_sums + shift_ * frames};
}

void FramePowers::push(const Forms<DoubleDouble>& forms) {
  wide_.push_back(forms);
  rounded_.push_back({rounded(forms.discrete), rounded(forms.matched), rounded(forms.exact_law)});
}

}  // namespace hyrax
