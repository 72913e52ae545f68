// `hyrax-sim study rest`.
#pragma once

#include "tools/hyrax-sim/study.h"

namespace hyrax {

[[nodiscard]] StudyOutcome make_rest(const StudyRequest& request);

}  // namespace hyrax
