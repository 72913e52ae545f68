// The study of what must hold in every step, however hard the scene.
#pragma once

#include "tools/hyrax-sim/study.h"

namespace hyrax {

/// Of scenarios/hard in the current folder where no scenario is given. --quick leaves the long cases out.
[[nodiscard]] StudyOutcome make_hard_cases(const StudyRequest& request);

}  // namespace hyrax
