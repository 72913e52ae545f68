// The core that plays a scenario.
#pragma once

#include <string>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// The program's core with the scenario's parameters. @param path names the scenario.
/// ERRORS: Failure(bad_input) "PATH: /parameters: ..." if the core takes none, or with a line for each of
/// another name.
[[nodiscard]] Core run_core(const Core& core, const std::string& path, const Scenario& scenario);

}  // namespace hyrax
