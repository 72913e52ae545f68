// Two trajectory files that were compared, as text and as JSON.
#pragma once

#include <string>

#include "tools/app/diff/trajectory_diff.h"
#include "tools/files/json.h"
#include "tools/store/provenance.h"

namespace hyrax {

/// comparison_text, energy, the worst value of each field, and which build settings of the programs that made
/// the files differ, with what that usually means for a difference of that class. Complete lines, indented by
/// two; of files without a difference the build settings only, if `lists_all`.
[[nodiscard]] std::string diff_text(const TrajectoryDiff& diff, const Provenance& a, const Provenance& b,
                                    bool lists_all);

/// {"agree", "class", "max_px", ..., "worst", "contacts"}
[[nodiscard]] Json diff_json(const TrajectoryDiff& diff);

}  // namespace hyrax
