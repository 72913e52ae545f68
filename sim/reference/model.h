// The laws of motion as the reference knows them: its own copy of the paper's table.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "sim/motion/state.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {

/// The paper's table; the reference never sees the shipped core, so these numbers are repeated here.
/// Source: "Use of physics in hyrax.exe", table 1.
[[nodiscard]] constexpr Constants paper_constants() {
  return {.gravity_px_per_s2 = 1200.0,
          .restitution = 0.6,
          .air_drag = 0.999,
          .ground_friction = 0.8,
          .rest_threshold_px_per_s = 5.0};
}

/// Gravity is >= 0, air_drag 0.5 .. 1. Tests use others than the paper's: air_drag = 1 for flight without
/// drag, another air_drag with its model_rate_hz for drag that is normalised by rate.
struct Model : Constants {
  constexpr Model() : Constants(paper_constants()) {}
  /// Drag and friction as at 60 Hz.
  constexpr explicit Model(const Constants& constants) : Constants(constants) {}

  double model_rate_hz = 60.0;  ///< Frame rate at which air_drag is a law of nature.
};

/// By which runs of a core are measured: of the paper's model this table with the scenario's parameters, so
/// that a changed constant of the shipped core shows as an error; of any other core the constants that it
/// played with, or without any the table.
[[nodiscard]] inline Model reference_model(std::string_view physics,
                                           const std::optional<Constants>& constants,
                                           const std::vector<Parameter>& parameters) {
  if (constants && !is_paper_model(physics)) return Model(*constants);
  Model model;
  set_parameters(parameters, kPaperNames, model);
  return model;
}

}  // namespace hyrax
