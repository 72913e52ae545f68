// The laws by which the reference measures runs of a core.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/core/core.h"
#include "sim/motion/state.h"
#include "sim/reference/model.h"

namespace hyrax {

/// Of the paper's model the reference's own table, so that a changed constant of the shipped core shows as an
/// error; of any other core its constants, or without any that table.
[[nodiscard]] Model reference_model(std::string_view physics, const std::optional<Constants>& constants);
[[nodiscard]] Model reference_model(const Core& core);

/// What the reference does not allow of constants, as "AIR_DRAG: must be 0.5 .. 1 (found 0.3)"; empty:
/// nothing.
[[nodiscard]] std::string why_not_measurable(const Constants& constants);

}  // namespace hyrax
