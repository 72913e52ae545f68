#include "sim/replay/action_effect.h"

#include "sim/replay/kernel.h"

namespace hyrax {
namespace {

struct Effect {
  Keyframe& state;

  void operator()(const Fling& flung) const { fling(state.row, flung.velocity); }
  void operator()(const Place& placed) const { place(state.row, placed.position); }
  void operator()(const Stop&) const { stop(state.row); }
  void operator()(const Resize& resize) const {
    state.window = resize.window.value_or(state.window);
    state.sprite = resize.sprite.value_or(state.sprite);
  }
  void operator()(const Hitch&) const {}
  void operator()(const Grab&) const {
    stop(state.row);
    state.is_held = true;
  }
  void operator()(const Release& release) const {
    fling(state.row, release.velocity);
    state.is_held = false;
  }
};

}  // namespace

void apply(const Action& action, Keyframe& state) { std::visit(Effect{state}, action); }

}  // namespace hyrax
