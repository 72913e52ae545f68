// The result of `diff` as text and as JSON.
#pragma once

#include <string>

#include "tools/app/diff/trajectory_diff.h"
#include "tools/files/json.h"

namespace hyrax {

/// "no position differs", or "at most 3.4 px apart". One line.
[[nodiscard]] std::string distance_sentence(const TrajectoryDiff& diff);

/// "2 contacts moved, 0 vanished, 1 appeared". One line.
[[nodiscard]] std::string contacts_sentence(const ContactChanges& contacts);

/// What a user of the program would see: distance, where the sprite ends, contacts, energy. Complete lines,
/// indented by two.
[[nodiscard]] std::string consequence_text(const TrajectoryDiff& diff);

/// The first difference, the contacts that moved, the worst value of each field: bits and ulps only where
/// both play the same scenario. Complete lines, indented by two.
[[nodiscard]] std::string values_text(const TrajectoryDiff& diff, bool lists_all);

/// {"agree", "class", "first_divergence", "worst", "contacts"}; without ulps where the scenarios differ.
[[nodiscard]] Json diff_json(const TrajectoryDiff& diff);

}  // namespace hyrax
