// Golden files without a scenario, and their removal.
#pragma once

#include <string>
#include <vector>

namespace hyrax {

/// Paths of the golden files without a scenario, .h5 and .txt each: those that `check` reports for the same
/// arguments as unreferenced.
/// @param folders named `scenarios`, or below one.
/// ERRORS: Failure(bad_input) for another argument, Failure(cannot_access) for a folder that cannot be read
/// or changed.
[[nodiscard]] std::vector<std::string> find_prunable(const std::vector<std::string>& folders,
                                                     const std::string& golden_folder);

/// ERRORS: Failure(cannot_access) "PATH: cannot be removed: REASON"; those before it are removed.
void prune(const std::vector<std::string>& files);

}  // namespace hyrax
