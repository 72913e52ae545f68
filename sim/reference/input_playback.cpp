#include "sim/reference/input_playback.h"

#include <utility>

namespace hyrax {
namespace {

Size size_of(const Input& input) {
  return {static_cast<std::int32_t>(input.a), static_cast<std::int32_t>(input.b)};
}

}  // namespace

InputPlayback::InputPlayback(const Scenario& scenario, std::vector<Input> inputs)
    : window_(scenario.window), sprite_(scenario.sprite), inputs_(std::move(inputs)) {}

InputChange InputPlayback::apply_due(Row& row) {
  InputChange change;
  for (; next_ < inputs_.size() && inputs_[next_].frame <= row.step; ++next_)
    apply(inputs_[next_], row, change);
  return change;
}

void InputPlayback::apply(const Input& input, Row& row, InputChange& change) {
  const auto set_velocity = [&](double vx_px_per_s, double vy_px_per_s) {
    row.vx_px_per_s = vx_px_per_s;
    row.vy_px_per_s = vy_px_per_s;
    change.sets_velocity = true;
  };
  change.ends_arc |= input.kind != InputKind::hitch;
  switch (input.kind) {
    case InputKind::fling:
      set_velocity(input.a, input.b);
      break;
    case InputKind::place:
      row.x_px = input.a;
      row.y_px = input.b;
      change.sets_position = true;
      break;
    case InputKind::stop:
      set_velocity(0.0, 0.0);
      break;
    case InputKind::resize_window:
      window_ = size_of(input);
      break;
    case InputKind::resize_sprite:
      sprite_ = size_of(input);
      break;
    case InputKind::hitch:
      break;
    case InputKind::grab:
      set_velocity(0.0, 0.0);
      is_held_ = change.grabs = true;
      break;
    case InputKind::release:
      set_velocity(input.a, input.b);
      is_held_ = false;
      break;
  }
}

}  // namespace hyrax
