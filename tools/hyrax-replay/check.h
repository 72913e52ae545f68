// hyrax-replay check: scenarios against the state hashes in the summaries of their golden files.
#pragma once

#include <string>
#include <vector>

#include "sim/core/core.h"
#include "tools/files/failure.h"

namespace hyrax {

/// Plays scenarios, compares their state hashes and judges their expectations; prints a line for each that
/// does not agree, and the counts. Words and exit codes are those of `hyrax-sim check`, which compares all of
/// a golden file; here only its summary is read, of that only the state hash.
/// @param arguments what follows `check`: scenarios, folders and options.
/// ERRORS: Failure(bad_input) for bad usage; those of list_scenarios.
[[nodiscard]] ExitCode check(const Core& core, const std::vector<std::string>& arguments);

}  // namespace hyrax
