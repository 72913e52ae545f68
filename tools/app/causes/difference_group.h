// Scenarios whose runs are not their golden files', grouped by cause: what `check` and `bless` show.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/cause/cause.h"
#include "sim/compare/comparison.h"
#include "tools/app/causes/core_check.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/files/json.h"

namespace hyrax {

/// Scenarios of one cause.
struct DifferenceGroup {
  Cause cause;
  std::vector<const PairVerdict*> scenarios;  ///< The worst first: by the largest distance, then by contacts.
  DifferenceClass difference = DifferenceClass::rounding;  ///< The widest.
  double max_px = 0.0;                                     ///< Largest distance of two rows of the same step.
  std::int64_t contacts_moved = 0;                         ///< Moved, only old and only new, summed.
  bool are_contacts_cut = false;                           ///< At least so many: ContactChanges::is_cut.
  std::optional<double> rest_shift_px;  ///< Largest distance of the final rows where both runs have settled.
};

/// The non_finite_text of a run that differs; empty where it stays finite.
[[nodiscard]] std::string non_finite_text(const PairVerdict& scenario);

/// Runs that become non-finite first; then known causes by their size, then unknown ones. The cores take the
/// runs that differ because of them.
/// @param scenarios whose runs are not their golden files'; they outlive the groups.
[[nodiscard]] std::vector<DifferenceGroup> group_by_cause(const std::vector<const PairVerdict*>& scenarios,
                                                          CoreChecks& cores);

/// {"operation", "detail", ...}, an entry of "groups"; scenarios in order of their paths.
[[nodiscard]] Json group_json(const DifferenceGroup& group);

}  // namespace hyrax
