// What an action does to the sprite and its window: the one place that says so.
#pragma once

#include <variant>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// What each kind of action does to a body; see apply.
template <class Body>
struct ActionEffect {
  Body& on;

  void operator()(const Fling& fling) const {
    on.setVelocity(fling.velocity.vx_px_per_s, fling.velocity.vy_px_per_s);
  }
  void operator()(const Place& place) const { on.setPos(place.position.x_px, place.position.y_px); }
  void operator()(const Stop&) const { on.resetVelocity(); }
  void operator()(const Resize& resize) const {
    if (resize.window) on.window = *resize.window;
    if (resize.sprite) on.sprite = *resize.sprite;
  }
  void operator()(const Hitch&) const {}
  void operator()(const Grab&) const {
    on.resetVelocity();
    on.is_held = true;
  }
  void operator()(const Release& release) const {
    on.setVelocity(release.velocity.vx_px_per_s, release.velocity.vy_px_per_s);
    on.is_held = false;
  }
};

/// Applies an action before the frame it falls on. A hitch changes nothing: it is the dt of its frame.
/// @tparam Body has the setters of class physics, setPos, setVelocity and resetVelocity, and the members
/// `window`, `sprite` and `is_held`.
template <class Body>
void apply(const Action& action, Body& body) {
  std::visit(ActionEffect<Body>{body}, action);
}

}  // namespace hyrax
