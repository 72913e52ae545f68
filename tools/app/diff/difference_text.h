// A comparison as text and as JSON: of two runs, or of two trajectory files.
#pragma once

#include <string>

#include "sim/compare/comparison.h"
#include "tools/app/diff/trajectory_diff.h"
#include "tools/files/json.h"
#include "tools/store/provenance.h"

namespace hyrax {

/// What differs: class, first divergent step and field, both values in decimal and hex float, ulps,
/// the rows around it, the contacts that moved (of each list the first 8, unless `lists_all`). Complete
/// lines, indented by two.
[[nodiscard]] std::string difference_text(const Comparison& comparison, bool lists_all = false);

/// Which build settings of the programs that made two files differ, and what that usually means for a
/// difference of that class; nothing: they agree. Complete lines, indented by two.
[[nodiscard]] std::string build_text(const Provenance& a, const Provenance& b,
                                     const std::optional<DifferenceClass>& difference);

/// The largest distance of two rows in px: 0 if no position differs.
[[nodiscard]] Json max_px_json(const Comparison& comparison);

/// {"step", "field", "expected", "actual", "ulps"}, or null.
[[nodiscard]] Json divergence_json(const std::optional<Divergence>& divergence);

/// "no position differs", or "at most 3.4 px apart". One line.
[[nodiscard]] std::string distance_sentence(const TrajectoryDiff& diff);

/// "2 contacts moved, 0 vanished, 1 appeared". One line.
[[nodiscard]] std::string contacts_sentence(const ContactChanges& contacts);

/// What a user of the program would see: distance, where the sprite ends, contacts, energy. Complete lines,
/// indented by two.
[[nodiscard]] std::string consequence_text(const TrajectoryDiff& diff);

/// The first difference, the contacts that moved, the worst value of each field. Complete lines, indented by
/// two.
[[nodiscard]] std::string values_text(const TrajectoryDiff& diff, bool lists_all);

/// {"agree", "class", "first_divergence", "worst", "contacts"}
[[nodiscard]] Json diff_json(const TrajectoryDiff& diff);

}  // namespace hyrax
