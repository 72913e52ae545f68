#include "sim/trajectory/input.h"

namespace hyrax {
namespace {

Input resized(std::int64_t frame, InputKind kind, const Size& size) {
  return {frame, kind, static_cast<double>(size.width_px), static_cast<double>(size.height_px)};
}

struct ActionInputs {
  std::int64_t frame;

  std::vector<Input> operator()(const Fling& fling) const {
    return {{frame, InputKind::fling, fling.velocity.vx_px_per_s, fling.velocity.vy_px_per_s}};
  }
  std::vector<Input> operator()(const Place& place) const {
    return {{frame, InputKind::place, place.position.x_px, place.position.y_px}};
  }
  std::vector<Input> operator()(const Stop&) const { return {{frame, InputKind::stop, 0.0, 0.0}}; }
  std::vector<Input> operator()(const Resize& resize) const {
    std::vector<Input> inputs;
    if (resize.window) inputs.push_back(resized(frame, InputKind::resize_window, *resize.window));
    if (resize.sprite) inputs.push_back(resized(frame, InputKind::resize_sprite, *resize.sprite));
    return inputs;
  }
  std::vector<Input> operator()(const Hitch& hitch) const {
    return {{frame, InputKind::hitch, hitch.dt_s, 0.0}};
  }
  std::vector<Input> operator()(const Grab&) const { return {{frame, InputKind::grab, 0.0, 0.0}}; }
  std::vector<Input> operator()(const Release& release) const {
    return {{frame, InputKind::release, release.velocity.vx_px_per_s, release.velocity.vy_px_per_s}};
  }
};

}  // namespace

std::vector<Input> inputs_of(const Action& action, std::int64_t frame) {
  return std::visit(ActionInputs{frame}, action);
}

std::vector<Input> inputs_of(const Scenario& scenario, const std::vector<std::int64_t>& frames,
                             std::int64_t frame_end) {
  std::vector<Input> inputs;
  for (std::size_t event = 0; event < frames.size() && frames[event] < frame_end; ++event)
    for (const Input& input : inputs_of(scenario.events[event].action, frames[event]))
      inputs.push_back(input);
  return inputs;
}

}  // namespace hyrax
