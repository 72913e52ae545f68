// The shipped core, as the studies of its behaviour call it.
//
// Beside the replay's kernel and the methods that are timed, its source alone uses class physics: a control,
// or an author who tries other laws, compiles these anew, and every study shows the effect.
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

/// physics::fly, its first half: the step without walls.
[[nodiscard]] State core_flight(const State& body, double dt_s);

}  // namespace hyrax
