// The verdicts that an author expects of a study: a JSON file of the format `hyrax-verdicts/1`.
#pragma once

#include <string>

#include "sim/study/study.h"

namespace hyrax {

/// Reads { "format": "hyrax-verdicts/1", "verdicts": { "2.3-energy": "does not hold", ... } }.
/// ERRORS: Failure(cannot_access) if it cannot be read; Failure(bad_input) with every fault of its form.
/// Whether its names and verdicts exist is the study's to judge.
[[nodiscard]] ExpectedVerdicts read_expected_verdicts(const std::string& path);

}  // namespace hyrax
