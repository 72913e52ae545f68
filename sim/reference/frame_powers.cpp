#include "sim/reference/arc_solution.h"

#include <cassert>

#include "sim/reference/phi.h"

namespace hyrax {
namespace {

FramePower<double> hi_of(const FramePower<DoubleDouble>& wide) {
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
  const Phi frame = wide_phi(log_);
  phi1_ = frame.one;
  phi2_ = frame.two;
  kappa_ = quotient(model.air_drag, phi1_);  // -a ln(a) / (1 - a), for a = 1 as well.
  if (model.air_drag < 1.0) kappa_by_log_ = kappa_ * quotient(1.0, log_);
  shift_ = -(kappa_ * kappa_ * phi2_) + model.air_drag;
  rounded_.reserve(kFramesMax + 1);
  wide_.reserve(kFramesMax + 1);
  constexpr DoubleDouble kOne{1.0, 0.0};
  push({{kOne, {}, {}}, {kOne, {}, {}}, {kOne, {}, {}}});
  while (rounded_.size() <= kFramesMax) extend();
}

std::shared_ptr<const FramePowers> FramePowers::of(const Model& model) {
  static const auto kPaper = std::make_shared<const FramePowers>(Model{});
  return model.air_drag == Model{}.air_drag ? kPaper : std::make_shared<const FramePowers>(model);
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
  next.exact_law = exact_law_after(static_cast<double>(wide_.size()), next.discrete.power);
  push(next);
}

// phi1 = (e^z - 1) / z and phi2 = (e^z - 1 - z) / z^2; near 0, where these cancel, their series.
FramePower<DoubleDouble> FramePowers::exact_law_after(double frames, DoubleDouble power) const {
  constexpr double kCancels = -1.0 / 8192;
  const DoubleDouble z = log_ * frames;
  if (z.hi > kCancels) {
    const Phi p = wide_phi(z);
    return {power, kappa_ * p.one * frames, (kappa_ * kappa_ * p.two * frames + shift_) * frames};
  }
  const DoubleDouble gone = power + -1.0;
  return {power, kappa_by_log_ * gone, kappa_by_log_ * kappa_by_log_ * (gone + -z) + shift_ * frames};
}

void FramePowers::push(const Forms<DoubleDouble>& forms) {
  wide_.push_back(forms);
  rounded_.push_back({hi_of(forms.discrete), hi_of(forms.matched), hi_of(forms.exact_law)});
}

}  // namespace hyrax
