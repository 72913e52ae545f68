// The shipped core as functions of plain values, for checks and studies.
#pragma once

#include <cstdint>
#include <span>

#include "sim/motion/state.h"

namespace hyrax {

/// One call of physics::update.
/// REQUIRES: bounds are whole numbers within the range of int; of all functions here.
[[nodiscard]] State core_step(const State& body, double dt_s, const Bounds& bounds);

/// `steps` calls of physics::update with one dt.
[[nodiscard]] State core_steps(State body, double dt_s, const Bounds& bounds, std::int64_t steps);

/// Calls of physics::update through the frames, each in so many equal parts.
[[nodiscard]] State core_played(const State& body, std::span<const double> frames_s, const Bounds& bounds,
                                int parts = 1);

/// physics::resetVelocity.
[[nodiscard]] State core_stopped(const State& body);

/// One call of physics::update without walls.
[[nodiscard]] State core_flight(const State& body, double dt_s);

}  // namespace hyrax
