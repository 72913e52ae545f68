// Hard cases made from scenarios of a core that describes itself.
#pragma once

#include <vector>

#include "sim/described/described_core.h"
#include "sim/described/described_scenario.h"
#include "tools/app/study/study_command.h"

namespace hyrax {

/// Each scenario as it is, by frames of other lengths, jittered, with a hitch, for long, and with each value
/// that has limits at these; held to kGeneralRules. Broken: a case that breaks one.
[[nodiscard]] Result study_hard_cases(const DescribedCore& core,
                                      const std::vector<DescribedScenario>& scenarios,
                                      const StudyInput& input);

}  // namespace hyrax
