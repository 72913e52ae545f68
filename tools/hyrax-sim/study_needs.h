// `hyrax-sim study needs`.
#pragma once

#include "tools/hyrax-sim/study.h"

namespace hyrax {

[[nodiscard]] StudyOutcome make_needs(const StudyRequest& request);

}  // namespace hyrax
