// The shipped core as the studies of its behaviour ask it.
//
// Its source is the one of them that sees class physics, so that a control, or an author who tries other
// laws, exchanges that and the replay's kernel, and every study tells what became of them.
#pragma once

#include <cstdint>

#include "sim/replay/kernel.h"

namespace hyrax {

/// The table of class physics, read from it.
struct CoreConstants {
  double gravity_px_per_s2 = 0.0;
  double restitution = 0.0;              ///< [-]
  double air_drag = 0.0;                 ///< [-], a step.
  double ground_friction = 0.0;          ///< [-], a ground contact.
  double rest_threshold_px_per_s = 0.0;  ///< Below it a ground contact stops vy.
};

/// Where the sprite's top left corner may be: 0 .. right, 0 .. bottom. Negative: there is no room.
struct Bounds {
  std::int32_t right_px = 0;
  std::int32_t bottom_px = 0;
  bool operator==(const Bounds&) const = default;
};

[[nodiscard]] CoreConstants core_constants();

/// One call of physics::update.
[[nodiscard]] Body core_step(const Body& body, double dt_s, Bounds bounds);

/// `steps` calls of physics::update with one dt.
[[nodiscard]] Body core_steps(Body body, double dt_s, Bounds bounds, std::int64_t steps);

/// physics::resetVelocity.
[[nodiscard]] Body core_stopped(const Body& body);

/// physics::fly, its first half: the step without walls.
[[nodiscard]] Body core_flight(const Body& body, double dt_s);

}  // namespace hyrax
