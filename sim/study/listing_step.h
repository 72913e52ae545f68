// The step of the paper's listing with its constants and its order free, for what-if questions: without
// drag, elastic, in another order. With the core's constants and the paper's order it is the core, bit for
// bit, or the core is no longer the listing's.
#pragma once

#include "sim/study/core.h"

namespace hyrax {

enum class StepOrder : std::uint8_t {
  paper,           ///< Gravity, drag, position, walls in x, walls in y.
  drag_first,      ///< Drag, gravity, position, walls.
  position_first,  ///< Position with the old velocity, gravity, drag, walls: explicit Euler.
  y_walls_first,   ///< As the paper's, with the walls in y before those in x.
  walls_first,     ///< Walls, gravity, drag, position.
};

[[nodiscard]] Body listing_step(const CoreConstants& constants, StepOrder order, Body body, double dt_s,
                                Bounds bounds);

/// Steps of random flings, contacts among them, in which the core is not the listing's step with the core's
/// own constants, in the paper's order, bit for bit.
[[nodiscard]] std::int64_t steps_unlike_listing(std::int64_t steps);

}  // namespace hyrax
