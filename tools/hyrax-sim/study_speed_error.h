// `hyrax-sim study speed-error`.
#pragma once

#include "tools/hyrax-sim/study.h"

namespace hyrax {

[[nodiscard]] StudyOutcome make_speed_error(const StudyRequest& request);

}  // namespace hyrax
