// The laws of motion as the reference knows them: its own copy of the paper's table.
#pragma once

#include "sim/motion/state.h"

namespace hyrax {

/// Source: "Use of physics in hyrax.exe", table 1. The reference never sees the shipped core, so
/// these numbers are repeated here, and tests use others: air_drag = 1 for
/// flight without drag, another air_drag with its model_rate_hz for drag that is normalised by rate.
struct Model {
  double gravity_px_per_s2 = 1200.0;     ///< Downwards, >= 0.
  double air_drag = 0.999;               ///< [-], velocity factor of a frame, 0.5 .. 1.
  double restitution = 0.6;              ///< [-], ratio of speeds after and before a bounce.
  double ground_friction = 0.8;          ///< [-], horizontal velocity factor of a ground contact.
  double rest_threshold_px_per_s = 5.0;  ///< Below it a ground contact stops vy.
  double model_rate_hz = 60.0;           ///< Frame rate at which air_drag is a law of nature.
};

/// The table as the constants of a core.
[[nodiscard]] inline Constants paper_constants() {
  const Model paper;
  return {.gravity_px_per_s2 = paper.gravity_px_per_s2,
          .restitution = paper.restitution,
          .air_drag = paper.air_drag,
          .ground_friction = paper.ground_friction,
          .rest_threshold_px_per_s = paper.rest_threshold_px_per_s};
}

}  // namespace hyrax
