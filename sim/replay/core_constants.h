// What this program's core is: its model and its constants.
#pragma once

#include <string_view>

#include "sim/motion/state.h"

namespace hyrax {

/// The name of the core's model: kPhysicsModel, or that of a core of one's own
/// (sim/trajectory/physics_model.h).
[[nodiscard]] std::string_view core_model();

/// The constants of class physics, read from it: few sources include the core itself.
/// REQUIRES: is_paper_model(core_model()).
[[nodiscard]] Constants core_constants();

}  // namespace hyrax
