// The laws of motion that do not know the frame: what a method must approach as its frames grow short.
#pragma once

#include <cmath>

#include "sim/reference/model.h"

namespace hyrax {

/// The fixed ODE: the paper's factors of a frame as rates, taken at the model's 60 Hz.
///
/// Flight: v' = g - k v with k = -60 ln 0.999 = 0.06003 1/s. A wall met at speed v is left at 0.6 v; the
/// ground takes a fifth of vx at every impact, and one after which the speed is below 5 px/s is the last:
/// from then on the sprite slides, vx' = -(k + f) vx with f = -60 ln 0.8 = 13.39 1/s.
struct FixedLaws {
  explicit FixedLaws(const Model& model = {})
      : gravity_px_per_s2(model.gravity_px_per_s2),
        drag_rate_per_s(-std::log(model.air_drag) * model.model_rate_hz),
        friction_rate_per_s(-std::log(model.ground_friction) * model.model_rate_hz),
        restitution(model.restitution),
        ground_friction(model.ground_friction),
        rest_threshold_px_per_s(model.rest_threshold_px_per_s) {}

  double gravity_px_per_s2;
  double drag_rate_per_s;
  double friction_rate_per_s;  ///< Of a sprite that lies on the ground.
  double restitution;
  double ground_friction;  ///< [-], of one impact.
  double rest_threshold_px_per_s;
};

}  // namespace hyrax
