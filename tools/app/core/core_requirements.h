// What a command requires of the core: the paper's step, measurable constants, that a file is of it.
#pragma once

#include <string>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// A core whose class has none of the paper's names for the constants of its step, with those of its header:
/// where one constant of the header, a double, and no other number in it has the value.
[[nodiscard]] Core with_header_names(Core core);

/// ERRORS: Failure(bad_input) "WHAT: needs the paper's step ..." with the first expression that is not the
/// paper's, if this program's core has another; or if the reference does not allow its constants.
void require_paper_core(const Core& core, const std::string& what);

/// As require_paper_core, for the bounds of errors in `expect`: they are measured against the paper's laws.
/// @param path of the scenario, for the message.
void require_measurable(const Core& core, const std::string& path, const Scenario& scenario);

/// ERRORS: Failure(bad_input) if a file's run is of another core than this program's. Numbers of the paper's
/// model compare with each other.
void require_own_core(const Core& core, const std::string& path, const std::string& physics);

}  // namespace hyrax
