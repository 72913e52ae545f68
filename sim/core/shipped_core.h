// The core that this project is about.
#pragma once

namespace hyrax {

struct Core;

/// Of class physics (sim/physics/physics.h). For `main` and for tests: all else is given its core.
[[nodiscard]] const Core& shipped_core();

}  // namespace hyrax
