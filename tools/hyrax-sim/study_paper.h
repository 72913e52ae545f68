// The study of the paper's claims, each measured.
#pragma once

#include "tools/hyrax-sim/study.h"

namespace hyrax {

/// ERRORS: those of unexpected_verdicts (verdict_file.h).
[[nodiscard]] StudyOutcome make_paper(const StudyRequest& request);

}  // namespace hyrax
