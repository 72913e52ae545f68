// Golden files without a scenario.
#pragma once

#include <string>
#include <vector>

namespace hyrax {

inline constexpr char kUnreferencedSentence[] =
    "no scenario for this golden file: the scenario was deleted, moved or renamed";

struct UnreferencedGolden {
  std::string path;           ///< Without its suffix; of a golden folder that cannot be read, the folder.
  std::string error;          ///< "FOLDER: cannot be read: REASON"; else empty.
  std::string scenario_path;  ///< Where its scenario would be.
};

/// The golden files without a scenario, each once, in name order: for every folder among `arguments` that is
/// named `scenarios` or below one, those in the corresponding golden folder, recursively. They are a
/// disagreement: an accepted result is not checked any more. golden/core/, the accepted core, is left out.
/// @param golden_folder empty if none was given.
[[nodiscard]] std::vector<UnreferencedGolden> find_unreferenced(const std::vector<std::string>& arguments,
                                                                const std::string& golden_folder);

}  // namespace hyrax
