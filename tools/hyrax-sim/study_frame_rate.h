// `hyrax-sim study frame-rate`.
#pragma once

#include "tools/hyrax-sim/study.h"

namespace hyrax {

[[nodiscard]] StudyOutcome make_frame_rate(const StudyRequest& request);

}  // namespace hyrax
