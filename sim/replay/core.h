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

/// Whether class physics does what the listing of sim/motion does with its constants: in a step from every
/// state of a grid on, beside and far from the bounds, in random flings at speeds of up to 1e12 px/s, and in
/// its setters. Then the listing's steps may replace the core's. Found out once.
[[nodiscard]] bool core_is_listing();

}  // namespace hyrax
