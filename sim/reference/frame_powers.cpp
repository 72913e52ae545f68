#include "sim/reference/frame_powers.h"

#include <cassert>

#include "sim/reference/phi.h"

namespace hyrax {
namespace {

FramePower<double> rounded(const FramePower<DoubleDouble>& wide) {
  return {wide.power.hi, wide.sum.hi, wide.sum_of_sums.hi};
}

}  // namespace

FramePowers::FramePowers(const Model& model) : air_drag_(model.air_drag), log_(wide_log(model.air_drag)) {
  assert(model.air_drag >= 0.5 && model.air_drag <= 1.0);
  const WidePhi frame = wide_phi(log_);
  phi1_ = frame.one;
  phi2_ = frame.two;
  rounded_.reserve(kFramesMax + 1);
  wide_.reserve(kFramesMax + 1);
  constexpr DoubleDouble kOne{1.0, 0.0};
  push({{kOne, {}, {}}, {kOne, {}, {}}});
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
  push(next);
}

void FramePowers::push(const Forms<DoubleDouble>& forms) {
  wide_.push_back(forms);
  rounded_.push_back({rounded(forms.discrete), rounded(forms.matched)});
}

}  // namespace hyrax
