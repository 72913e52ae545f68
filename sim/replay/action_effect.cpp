#include "sim/replay/action_effect.h"

namespace hyrax {
namespace {

struct Effect {
  Keyframe& state;

  void operator()(const Fling& fling) const { set_velocity(fling.velocity); }
  void operator()(const Place& place) const {
    state.row.x_px = place.position.x_px;
    state.row.y_px = place.position.y_px;
  }
  void operator()(const Stop&) const { set_velocity({}); }
  void operator()(const Resize& resize) const {
    state.window = resize.window.value_or(state.window);
    state.sprite = resize.sprite.value_or(state.sprite);
  }
  void operator()(const Hitch&) const {}
  void operator()(const Grab&) const {
    set_velocity({});
    state.is_held = true;
  }
  void operator()(const Release& release) const {
    set_velocity(release.velocity);
    state.is_held = false;
  }

  void set_velocity(const Velocity& velocity) const {
    state.row.vx_px_per_s = velocity.vx_px_per_s;
    state.row.vy_px_per_s = velocity.vy_px_per_s;
  }
};

}  // namespace

void apply(const Action& action, Keyframe& state) { std::visit(Effect{state}, action); }

}  // namespace hyrax
