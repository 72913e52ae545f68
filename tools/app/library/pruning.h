// Golden files of deleted scenarios.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace hyrax {

/// What --prune finds of the golden files that `check` reports for the same arguments as unreferenced.
struct Pruning {
  std::vector<std::string> removed;  ///< Files that bless wrote, .h5 and .txt each; of a link, the link.
  std::vector<std::string> left;     ///< Others, which stay.
};

/// Removes nothing yet.
/// @param is_golden_h5 whether bless wrote a .h5 file.
/// @param folders named `scenarios`, or below one.
/// ERRORS: Failure(bad_input) for another argument, for a folder without any scenario, and if the way to its
/// golden files is a link; Failure(cannot_access) if a folder cannot be changed. Failure of any kind if a
/// folder, a link or a scenario cannot be read: there may be scenarios that are not seen.
/// REQUIRES: as read_isolated.
[[nodiscard]] Pruning find_prunable(const std::vector<std::string>& folders, const std::string& golden_folder,
                                    const std::function<bool(const std::string& path)>& is_golden_h5);

/// ERRORS: Failure(cannot_access) "PATH: cannot be removed: REASON"; those before it are removed.
void remove_files(const std::vector<std::string>& files);

}  // namespace hyrax
