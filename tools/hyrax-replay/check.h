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
/// @param files scenarios and folders; none: the default ones. @param golden_folder empty if none was given.
/// ERRORS: those of list_scenarios.
[[nodiscard]] ExitCode check(const Core& core, std::vector<std::string> files,
                             const std::string& golden_folder);

}  // namespace hyrax
