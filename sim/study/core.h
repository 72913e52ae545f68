// The shipped core as the studies call it.
#pragma once

#include <cstdint>

#include "sim/motion/state.h"

namespace hyrax {

/// The constants of class physics, read from it.
[[nodiscard]] Constants core_constants();

/// One call of physics::update.
/// REQUIRES: bounds are whole numbers within the range of int.
[[nodiscard]] State core_step(const State& body, double dt_s, const Bounds& bounds);

/// `steps` calls of physics::update with one dt.
[[nodiscard]] State core_steps(State body, double dt_s, const Bounds& bounds, std::int64_t steps);

/// physics::resetVelocity.
[[nodiscard]] State core_stopped(const State& body);

/// One call of physics::update without walls.
[[nodiscard]] State core_flight(const State& body, double dt_s);

}  // namespace hyrax
