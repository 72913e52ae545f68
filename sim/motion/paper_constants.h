// The constants of a class that has them by the paper's names.
#pragma once

#include "sim/motion/state.h"

namespace hyrax {

template <class Physics>
concept HasPaperConstants = requires {
  Physics::GRAVITY + Physics::RESTITUTION + Physics::AIR_DRAG + Physics::GROUND_FRICTION +
      Physics::REST_THRESHOLD;
};

template <HasPaperConstants Physics>
[[nodiscard]] Constants constants_of() {
  return {.gravity_px_per_s2 = Physics::GRAVITY,
          .restitution = Physics::RESTITUTION,
          .air_drag = Physics::AIR_DRAG,
          .ground_friction = Physics::GROUND_FRICTION,
          .rest_threshold_px_per_s = Physics::REST_THRESHOLD};
}

}  // namespace hyrax
