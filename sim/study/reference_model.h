// The laws by which the reference measures runs of a core.
#pragma once

#include <optional>
#include <string>

#include "sim/core/core.h"
#include "sim/motion/state.h"
#include "sim/reference/model.h"

namespace hyrax {

[[nodiscard]] inline Model reference_model(const Core& core) {
  return reference_model(core.name, core.constants, core.parameters);
}

/// What the reference does not allow of constants, as "AIR_DRAG: must be 0.5 .. 1 (found 0.3)"; empty:
/// nothing.
[[nodiscard]] std::string why_not_measurable(const Constants& constants);
/// Whether a run of a core with such constants can be measured by the model.
[[nodiscard]] inline bool is_measurable(const std::optional<Constants>& constants, const Model& model) {
  return constants && why_not_measurable(model).empty();
}

}  // namespace hyrax
